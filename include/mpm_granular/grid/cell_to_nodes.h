#ifndef mpm_granular_grid_cell_to_nodes_h
#define mpm_granular_grid_cell_to_nodes_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/grid/cell_sums.h>
#include <mpm_granular/grid/node_sums.h>

#include <array>
#include <vector>

/*
 * What the sums of a cell give to its nodes (T9): the kernels of
 * NodalFields::gather_nodes() and gather_forces(), by kind of cell.
 */
namespace mpm_granular::Grid
{
  /// Where the numbers of the nodes of a tetrahedron are: mass and momentum,
  /// then force and load.
  using Places = std::array<double *, 4>;

  inline Places
  places_of(const std::array<unsigned int, 4> &nodes,
            std::vector<NodeSums<3>>          &sums)
  {
    static_assert(sizeof(NodeSums<3>) == 10 * sizeof(double));
    Places places;
    for (unsigned int k = 0; k < 4; ++k)
      places[k] = reinterpret_cast<double *>(&sums[nodes[k]]);
    return places;
  }

  /// Adds the internal forces of a tetrahedron to its nodes, with one lane
  /// for each component; in the fourth one, which belongs to the load, zeros.
  inline void
  add_forces(const Mesh::SimplexCell<3>             &cell,
             const StressSums<Mesh::SimplexCell<3>> &internal,
             const Places                           &places)
  {
    const auto &s         = internal.stress;
    const Lanes column[3] = {Lanes(s[0], s[3], s[5], 0.),
                             Lanes(s[3], s[1], s[4], 0.),
                             Lanes(s[5], s[4], s[2], 0.)};
    Lanes       rest      = 0.; // forces in a cell add up to zero
    for (unsigned int k = 0; k < 3; ++k)
      {
        const auto &g = cell.gradient[k];
        const Lanes resistance =
          column[0] * g[0] + column[1] * g[1] + column[2] * g[2];
        double *place = places[k + 1] + 4;
        store(load<Lanes>(place) - resistance, place);
        rest += resistance;
      }
    store(load<Lanes>(places[0] + 4) + rest, places[0] + 4);
  }

  inline void
  add_forces(const Mesh::SimplexCell<3>             &cell,
             const StressSums<Mesh::SimplexCell<3>> &internal,
             const std::array<unsigned int, 4>      &nodes,
             std::vector<NodeSums<3>>               &sums)
  {
    add_forces(cell, internal, places_of(nodes, sums));
  }

  /// Adds the internal forces of a cell to its nodes.
  template <int dim>
  inline void
  add_forces(const Mesh::SimplexCell<dim>             &cell,
             const StressSums<Mesh::SimplexCell<dim>> &internal,
             const std::array<unsigned int, dim + 1>  &nodes,
             std::vector<NodeSums<dim>>               &sums)
  {
    dealii::Tensor<2, dim> sigma; // sum_p V_p sigma_p
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      {
        const unsigned int i = stress_index[s][0], j = stress_index[s][1];
        if (i < dim && j < dim)
          sigma[i][j] = sigma[j][i] = internal.stress[s];
      }
    dealii::Tensor<1, dim> rest; // forces in a cell add up to zero
    for (unsigned int k = 0; k < dim; ++k)
      {
        dealii::Tensor<1, dim> force;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            force[i] -= sigma[i][j] * cell.gradient[k][j];
        sums[nodes[k + 1]].force += force;
        rest -= force;
      }
    sums[nodes[0]].force += rest;
  }

  template <int dim>
  inline void
  add_forces(const Mesh::BoxCell<dim> &,
             const StressSums<Mesh::BoxCell<dim>> &internal,
             const std::array<unsigned int, Mesh::BoxCell<dim>::n_nodes> &nodes,
             std::vector<NodeSums<dim>>                                  &sums)
  {
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < dim; ++d)
        sums[nodes[k]].force[d] += internal.force[d][k];
  }

  /// Adds the mass and momentum of a cell to its nodes.
  template <class Cell, int dim>
  inline void
  add_mass_and_momentum(const CellSums<Cell>                          &cell,
                        const std::array<unsigned int, Cell::n_nodes> &nodes,
                        std::vector<NodeSums<dim>>                    &sums)
  {
    for (unsigned int k = 0; k < Cell::n_nodes; ++k)
      {
        NodeSums<dim> &node = sums[nodes[k]];
        for (unsigned int j = 0; j < Cell::n_nodes; ++j)
          node.mass += cell.mass(k, j);
        for (unsigned int d = 0; d < dim; ++d)
          node.momentum[d] += cell.momentum[d][k];
      }
  }

  /// In a tetrahedron with a lane for each node, then for mass and each
  /// component of the momentum.
  inline void
  add_mass_and_momentum(const CellSums<Mesh::SimplexCell<3>> &cell,
                        const Places                         &places)
  {
    const double *mass        = cell.mass.entries.data();
    Lanes         of_nodes[4] = {load<Lanes>(mass) + load<Lanes>(mass + 4) +
                                   load<Lanes>(mass + 8) + load<Lanes>(mass + 12),
                                 load<Lanes>(cell.momentum[0].data()),
                                 load<Lanes>(cell.momentum[1].data()),
                                 load<Lanes>(cell.momentum[2].data())};
    transpose(of_nodes);
    for (unsigned int k = 0; k < 4; ++k)
      store(load<Lanes>(places[k]) + of_nodes[k], places[k]);
  }

  /// Adds the contributions of a cell to its nodes.
  template <int dim, class Cell>
  inline void
  add_cell(const Cell                                    &cell,
           const CellSums<Cell>                          &of_cell,
           const std::array<unsigned int, Cell::n_nodes> &slots,
           const bool                                     with_forces,
           std::vector<NodeSums<dim>>                    &sums)
  {
    add_mass_and_momentum(of_cell, slots, sums);
    if (with_forces)
      add_forces(cell, of_cell.internal, slots, sums);
  }

  inline void
  add_cell(const Mesh::SimplexCell<3>           &cell,
           const CellSums<Mesh::SimplexCell<3>> &of_cell,
           const std::array<unsigned int, 4>    &slots,
           const bool                            with_forces,
           std::vector<NodeSums<3>>             &sums)
  {
    const Places places = places_of(slots, sums);
    add_mass_and_momentum(of_cell, places);
    if (with_forces)
      add_forces(cell, of_cell.internal, places);
  }
} // namespace mpm_granular::Grid

#endif
