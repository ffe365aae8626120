#ifndef mpm_granular_mesh_point_walk_h
#define mpm_granular_mesh_point_walk_h

#include <mpm_granular/mesh/background_mesh.h>

#include <algorithm>
#include <array>

namespace mpm_granular::Mesh
{
  /// Shape values of a point in its host cell; cell is no_cell if it has none.
  template <int dim>
  struct HostCell
  {
    unsigned int                cell;
    std::array<double, dim + 1> shape_values;
  };

  /// A point this far outside (in barycentric coordinates) still belongs to a
  /// cell: round-off may not decide between two neighbours for ever.
  inline constexpr double inside_tolerance = 1e-12;

  /// A point this far beyond a boundary face still belongs to the mesh: walls
  /// hold points, and their positions drift by round-off only.
  inline constexpr double boundary_tolerance = 1e-6;

  /**
   * Walks from @p start to the simplex that holds @p x: across the face opposite
   * to the node with the most negative shape value, until none is negative. A
   * point that moved by less than a cell is found in one or two steps.
   *
   * @return the host cell, or no_cell if @p x lies beyond the boundary, as seen
   *   from the last cell of the walk.
   */
  template <int dim>
  HostCell<dim>
  walk_to(const BackgroundMesh<dim> &mesh,
          const dealii::Point<dim>  &x,
          const unsigned int         start)
  {
    // A walk visits each cell at most a few times; a cycle means a mesh with
    // degenerate cells, and ends as a lost point.
    constexpr unsigned int max_steps = 10000;

    HostCell<dim> host{start, {}};
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        const SimplexCell<dim> &cell = mesh.cell(host.cell);
        host.shape_values            = cell.shape_values(x);

        unsigned int exit           = no_cell;
        double       most_negative  = -inside_tolerance;
        bool         beyond_surface = false;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            const double value = host.shape_values[k];
            if (cell.neighbor[k] != no_cell)
              {
                if (value < most_negative)
                  {
                    most_negative = value;
                    exit          = cell.neighbor[k];
                  }
              }
            else if (value < -boundary_tolerance)
              beyond_surface = true;
          }
        if (exit == no_cell)
          {
            if (beyond_surface)
              host.cell = no_cell;
            return host;
          }
        host.cell = exit;
      }
    host.cell = no_cell;
    return host;
  }
} // namespace mpm_granular::Mesh

#endif
