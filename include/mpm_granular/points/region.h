#ifndef mpm_granular_points_region_h
#define mpm_granular_points_region_h

#include <mpm_granular/parameters/choice.h>
#include <mpm_granular/points/point_layout.h>
#include <mpm_granular/points/region_shape.h>

#include <string>
#include <vector>

namespace mpm_granular::Points
{
  /// A part of space filled with points of one material.
  template <int dim>
  class Region : public Parameters::ParameterGroup
  {
  public:
    Region();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// The points of the region, as PointLayout gives them. Collective.
    /// @throws InputError if there are none.
    std::vector<Seed<dim>>
    fill(const Mesh::BackgroundMesh<dim> &mesh,
         const std::string               &input_file) const;

    /// Name of the material the points consist of.
    const std::string &
    material_name() const
    {
      return material;
    }

    /// Whether place @p x in cell @p cell belongs to the region; for regions
    /// that were filled.
    bool
    contains(const dealii::Point<dim> &x, const unsigned int cell) const
    {
      return shape->contains(x, cell);
    }

  private:
    std::string                          material;
    Parameters::Choice<RegionShape<dim>> shape;
    Parameters::Choice<PointLayout<dim>> layout;
  };
} // namespace mpm_granular::Points

#endif
