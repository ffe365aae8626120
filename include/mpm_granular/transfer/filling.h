#ifndef mpm_granular_transfer_filling_h
#define mpm_granular_transfer_filling_h

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/transfer/point_block.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * How far the cells of a mesh, and the surroundings of its nodes, are filled
   * with material (T40). The gaps between points that have separated do not
   * count.
   *
   * Use: clear(), add() every block of points, sum().
   */
  template <int dim>
  class Filling
  {
  public:
    /// See Averaging::reinit().
    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume);

    void
    clear()
    {
      parts.clear();
    }

    /// Adds the volumes of a block's points to their host cells.
    void
    add(const Points::PointArrays<dim> &points,
        const PointBlock<dim>          &block,
        const Grid::NodalFields<dim>   &fields);

    /// Sums the volumes of cells and nodes over all ranks. Cells that this rank
    /// owns become active if other ranks have points in them.
    void
    sum(Grid::NodalFields<dim> &fields);

    /// Volume of the points in a cell, by slot [m^3], in 2D [m^2].
    double
    of_cell(const unsigned int slot) const
    {
      double volume = 0.;
      if (slot < parts.size() / n_nodes)
        for (unsigned int k = 0; k < n_nodes; ++k)
          volume += parts[slot * n_nodes + k];
      return volume;
    }

    /// theta, the part of a node's surroundings that is filled, by slot.
    double
    fraction(const Grid::NodalFields<dim> &fields,
             const unsigned int            slot) const
    {
      return fields.hanging.value_at(fractions, slot);
    }

    /// From this fraction on, the surroundings of a node count as full: points
    /// that are not in order leave some cells poorer than others.
    static constexpr double full = 0.9;

    /// Whether each node's surroundings are full, by slot, hanging ones too.
    std::vector<std::uint8_t>
    full_nodes(const Grid::NodalFields<dim> &fields) const;

    void
    serialize(Core::Archive &archive);

  private:
    template <class Cell>
    void
    add_in(const Points::PointArrays<dim> &points,
           const PointBlock<dim>          &block,
           const Grid::NodalFields<dim>   &fields);

    const Mesh::BackgroundMesh<dim> *mesh      = nullptr;
    const Mesh::Partition<dim>      *partition = nullptr;
    unsigned int                     n_nodes   = 0;           ///< of a cell
    std::vector<double>              largest_specific_volume; ///< by material
    std::vector<double> parts;     ///< sum_p V_p N_k by cell slot, then vertex
    std::vector<double> fractions; ///< by node slot
  };
} // namespace mpm_granular::Transfer

#endif
