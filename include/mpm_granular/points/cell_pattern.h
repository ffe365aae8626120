#ifndef mpm_granular_points_cell_pattern_h
#define mpm_granular_points_cell_pattern_h

#include <mpm_granular/points/point_layout.h>

#include <vector>

namespace mpm_granular::Points
{
  /// Points that are laid out in the same way in every cell.
  struct CellPattern
  {
    struct Place
    {
      std::vector<double> shape_values; ///< of the cell's nodes, there
      double              share;        ///< of the cell's volume
    };
    std::vector<Place> places;
  };

  /// Points of a pattern in every cell, as far as @p shape contains them.
  template <int dim>
  std::vector<Seed<dim>>
  repeat(const CellPattern               &pattern,
         const Mesh::BackgroundMesh<dim> &mesh,
         const RegionShape<dim>          &shape);

  /// Checks the entry `Points per cell` against the numbers that a layout has
  /// patterns for.
  /// @throws InputError if it is none of them.
  template <int dim>
  void
  check_points_per_cell(const unsigned int               given,
                        const std::vector<unsigned int> &valid,
                        const Mesh::BackgroundMesh<dim> &mesh);
} // namespace mpm_granular::Points

#endif
