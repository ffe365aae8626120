#ifndef mpm_granular_grid_node_sums_h
#define mpm_granular_grid_node_sums_h

#include <deal.II/base/tensor.h>

namespace mpm_granular::Grid
{
  /// What a node receives from the points.
  template <int dim>
  struct NodeSums
  {
    double                 mass = 0.; ///< [kg]
    dealii::Tensor<1, dim> momentum;  ///< [kg m/s]
    dealii::Tensor<1, dim> force;     ///< internal force [N]
    dealii::Tensor<1, dim> load;      ///< tractions, forces of place [N]
  };
} // namespace mpm_granular::Grid

#endif
