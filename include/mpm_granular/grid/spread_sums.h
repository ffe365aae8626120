#ifndef mpm_granular_grid_spread_sums_h
#define mpm_granular_grid_spread_sums_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/core/archive.h>
#include <mpm_granular/grid/node_sums.h>

#include <vector>

namespace mpm_granular::Grid
{
  /// A shape function of a node at the place of a point.
  template <int dim>
  struct NodeFunction
  {
    unsigned int           node;     ///< of the mesh
    double                 value;    ///< [-]
    dealii::Tensor<1, dim> gradient; ///< [1/m]
  };

  /**
   * What points give to nodes by shape functions that reach beyond their cells:
   * such points cannot be summed by cell. The sums go to the nodes directly,
   * and the sampled mass matrix (T11) is kept as the masses and shape values it
   * consists of. Empty with functions that end with the cell.
   */
  template <int dim>
  class SpreadSums
  {
  public:
    using Functions = dealii::ArrayView<const NodeFunction<dim>>;

    /// Forgets all, for a mesh with so many nodes.
    void
    reinit(const unsigned int n_nodes_of_mesh);

    /// Forgets all sums.
    void
    clear();

    /// Sets the forces to zero.
    void
    clear_forces();

    /// Adds mass and momentum of a point (T9).
    void
    add(const double                  mass,
        const dealii::Tensor<1, dim> &velocity,
        const Functions              &functions);

    /// Adds to the internal force of a node that has mass.
    void
    add_force(const unsigned int node, const dealii::Tensor<1, dim> &force)
    {
      sums[place_of_node[node]].force += force;
    }

    /// Calls @p action with each node that has received something, and with its
    /// NodeSums.
    template <class Action>
    void
    for_each_node(Action &&action) const
    {
      for (unsigned int i = 0; i < nodes.size(); ++i)
        action(nodes[i], sums[i]);
    }

    /// Adds (sampled mass matrix) . @p field to @p result; both by slot.
    template <class SlotOf>
    void
    add_mass_times(SlotOf                                   &&slot_of,
                   const std::vector<dealii::Tensor<1, dim>> &field,
                   std::vector<dealii::Tensor<1, dim>>       &result) const
    {
      for (unsigned int p = 0, begin = 0; p < masses.size(); ++p)
        {
          const unsigned int     end = begin + n_values[p];
          dealii::Tensor<1, dim> at_point;
          for (unsigned int i = begin; i < end; ++i)
            at_point += values[i] * field[slot_of(node_of_value[i])];
          at_point *= masses[p];
          for (unsigned int i = begin; i < end; ++i)
            result[slot_of(node_of_value[i])] += values[i] * at_point;
          begin = end;
        }
    }

    void
    serialize(Core::Archive &archive);

    std::size_t
    memory_consumption() const;

  private:
    bool
    is_known(const unsigned int node) const
    {
      return place_of_node[node] < nodes.size() &&
             nodes[place_of_node[node]] == node;
    }

    std::vector<unsigned int>  place_of_node; ///< in the next two arrays
    std::vector<unsigned int>  nodes;
    std::vector<NodeSums<dim>> sums;

    std::vector<double>       masses;   ///< of the points [kg]
    std::vector<unsigned int> n_values; ///< of each point, in the next two
    std::vector<unsigned int> node_of_value;
    std::vector<double>       values; ///< of the shape functions
  };
} // namespace mpm_granular::Grid

#endif
