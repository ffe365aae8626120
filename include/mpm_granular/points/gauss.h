#ifndef mpm_granular_points_gauss_h
#define mpm_granular_points_gauss_h

#include <mpm_granular/points/point_layout.h>

namespace mpm_granular::Points
{
  /**
   * The points of Gauss quadrature in every box, with volumes in proportion to
   * its weights. From two in each direction on they integrate the product of a
   * linear stress and the gradients of shape functions exactly. So a geostatic
   * state is at rest also beside cells of other sizes, where Symmetric is only
   * nearly so. In simplices Symmetric does as well.
   */
  template <int dim>
  class Gauss : public PointLayout<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    std::vector<Seed<dim>>
    seeds(const Mesh::BackgroundMesh<dim> &mesh,
          const RegionShape<dim>          &shape,
          const std::string               &input_file) const override;

  private:
    unsigned int points_per_cell = 4;
  };
} // namespace mpm_granular::Points

#endif
