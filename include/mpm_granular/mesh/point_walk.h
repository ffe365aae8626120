#ifndef mpm_granular_mesh_point_walk_h
#define mpm_granular_mesh_point_walk_h

#include <mpm_granular/mesh/background_mesh.h>

#include <vector>

namespace mpm_granular::Mesh
{
  /// Where a point has come to.
  struct HostCell
  {
    unsigned int cell; ///< no_cell if it lies beyond the boundary

    /// The point has left the cells that this rank knows, through a face of the
    /// cell above.
    bool is_beyond_reach;
  };

  /// A point this far outside (in barycentric coordinates) still belongs to a
  /// cell: round-off may not decide between two neighbours for ever.
  inline constexpr double inside_tolerance = 1e-12;

  /// A point this far beyond a boundary face still belongs to the mesh: walls
  /// hold points, and their positions drift by round-off only.
  inline constexpr double boundary_tolerance = 1e-6;

  /**
   * Walks from cell @p start to the one that holds @p x: across the face that x
   * is farthest beyond, until it is beyond none. A point that moved by less
   * than a cell is found in one or two steps.
   *
   * @param cells of a mesh: of SimplexCell or BoxCell.
   */
  template <class Cell>
  HostCell
  walk_to(const std::vector<Cell>        &cells,
          const dealii::Point<Cell::dim> &x,
          const unsigned int              start)
  {
    // A walk visits each cell at most a few times; a cycle means a mesh with
    // degenerate cells, and ends as a lost point.
    constexpr unsigned int max_steps = 10000;

    unsigned int host = start;
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        const Cell  &cell           = cells[host];
        const auto   heights        = cell.heights(x);
        unsigned int exit           = no_cell;
        double       lowest         = -inside_tolerance;
        bool         beyond_surface = false;
        for (unsigned int f = 0; f < Cell::n_faces; ++f)
          {
            if (cell.neighbor[f] != no_cell)
              {
                if (heights[f] < lowest)
                  {
                    lowest = heights[f];
                    exit   = cell.neighbor[f];
                  }
              }
            else if (heights[f] < -boundary_tolerance)
              beyond_surface = true;
          }
        if (exit == unknown_cell)
          return {host, true};
        if (exit == no_cell)
          return {beyond_surface ? no_cell : host, false};
        host = exit;
      }
    return {no_cell, false};
  }
} // namespace mpm_granular::Mesh

#endif
