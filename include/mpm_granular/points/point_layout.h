#ifndef mpm_granular_points_point_layout_h
#define mpm_granular_points_point_layout_h

#include <mpm_granular/core/registry.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/points/region_shape.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mpm_granular::Points
{
  /// A point to be made: its place, its host cell and the volume it stands for.
  template <int dim>
  struct Seed
  {
    dealii::Point<dim> position; ///< [m]
    unsigned int       cell;     ///< flat index
    double             volume;   ///< [m^3], in 2D [m^2]
    std::uint64_t      index;    ///< in the region, on any number of ranks
  };

  /// How the points of a region are laid out.
  template <int dim>
  class PointLayout : public Parameters::ParameterGroup
  {
  public:
    /**
     * The points of a region; of a distributed mesh those in own cells.
     * Collective.
     *
     * @param shape the part of space to fill.
     * @param input_file the parameter file that file names are relative to.
     * @throws InputError for points outside the mesh.
     */
    virtual std::vector<Seed<dim>>
    seeds(const Mesh::BackgroundMesh<dim> &mesh,
          const RegionShape<dim>          &shape,
          const std::string               &input_file) const = 0;
  };

  template <int dim>
  using PointLayoutRegistry = Core::Registry<PointLayout<dim>>;
} // namespace mpm_granular::Points

#endif
