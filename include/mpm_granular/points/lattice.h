#ifndef mpm_granular_points_lattice_h
#define mpm_granular_points_lattice_h

#include <mpm_granular/points/point_layout.h>

namespace mpm_granular::Points
{
  /**
   * Points on a regular lattice that starts half a spacing inside the lower
   * corner of the box around the shape, each with the volume of a lattice cell.
   */
  template <int dim>
  class Lattice : public PointLayout<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    std::vector<Seed<dim>>
    seeds(const Mesh::BackgroundMesh<dim> &mesh,
          const RegionShape<dim>          &shape,
          const std::string               &input_file) const override;

  private:
    dealii::Tensor<1, dim> spacing;
  };
} // namespace mpm_granular::Points

#endif
