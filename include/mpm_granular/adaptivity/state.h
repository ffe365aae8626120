#ifndef mpm_granular_adaptivity_state_h
#define mpm_granular_adaptivity_state_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/adaptivity/touching_cells.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/partition.h>

#include <cstdint>
#include <vector>

namespace mpm_granular::Adaptivity
{
  /// What criteria of refinement look at: the mesh, the points in its cells,
  /// and the motion of its nodes.
  template <int dim>
  class State
  {
  public:
    /**
     * Collective. All points are in own cells of their rank.
     *
     * @param fields after gather_nodes(), with the momenta of the points.
     * @param n_points as Points::MaterialPoints::count_by_cell() gives them: by
     *   cell, of all ranks; of a distributed mesh those in own cells.
     * @param time [s].
     */
    State(const Mesh::BackgroundMesh<dim>  &mesh,
          const Mesh::Partition<dim>       &partition,
          const Grid::NodalFields<dim>     &fields,
          const std::vector<std::uint32_t> &n_points,
          const double                      time);

    const Mesh::BackgroundMesh<dim> &mesh;
    const Mesh::Partition<dim>      &partition;
    const Grid::NodalFields<dim>    &fields;
    const double                     time; ///< [s]
    const TouchingCells<dim>         touching;

    /// The number of points in a cell, a ghost or not, over all ranks.
    unsigned int
    n_points(const unsigned int cell) const
    {
      return points_of_cells[cell];
    }

    /// How often a cell of the mesh as given was divided to get this one.
    unsigned int
    level(const unsigned int cell) const
    {
      return mesh.level(cell);
    }

    /// The edge of a box that the cell is, or of which it is a part if it is a
    /// simplex, from its volume [m].
    double
    size(const unsigned int cell) const;

    /// The gradient of the grid's velocity at the centre of an own cell; zero
    /// if the cell has no points [1/s].
    dealii::Tensor<2, dim>
    velocity_gradient(const unsigned int cell) const;

    /// The largest speed of a node, on all ranks [m/s]. Collective.
    double
    largest_speed() const;

    /// Brings the values of own cells of a distributed mesh to the ranks that
    /// have them as ghosts. Collective.
    /// @param values by cell.
    void
    send_to_ghosts(std::vector<unsigned int> &values) const;

  private:
    /// The velocity of an active node, or of a hanging one between such [m/s].
    dealii::Tensor<1, dim>
    velocity(const unsigned int node) const;

    std::vector<unsigned int> points_of_cells;
  };
} // namespace mpm_granular::Adaptivity

#endif
