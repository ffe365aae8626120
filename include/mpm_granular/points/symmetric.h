#ifndef mpm_granular_points_symmetric_h
#define mpm_granular_points_symmetric_h

#include <mpm_granular/points/point_layout.h>

namespace mpm_granular::Points
{
  /**
   * The same points in every cell, in symmetric positions, each with its share
   * of the cell's volume: linear stress is integrated exactly, and a geostatic
   * state is at rest.
   */
  template <int dim>
  class Symmetric : public PointLayout<dim>
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
