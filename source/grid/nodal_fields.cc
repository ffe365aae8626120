#include <mpm_granular/grid/cell_to_nodes.h>
#include <mpm_granular/grid/nodal_fields.h>

#include <cstring>
#include <tuple>
#include <type_traits>

namespace mpm_granular::Grid
{
  using namespace dealii;

  template <int dim>
  NodalFields<dim>::NodalFields(const Mesh::BackgroundMesh<dim> &mesh,
                                const Mesh::Partition<dim>      &partition)
    : shared(partition, &Mesh::Partition<dim>::Neighbor::nodes)
    , shared_cells(partition, &Mesh::Partition<dim>::Neighbor::cells)
    , mesh(mesh)
    , partition(partition)
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      all_cells  = ActiveCells<Cell>();
    });
    reinit();
  }

  template <int dim>
  void
  NodalFields<dim>::reinit()
  {
    clear_cells();
    spread.reinit(mesh.n_nodes());
    active_nodes.clear();
    cell_slot.assign(mesh.n_cells(), no_slot);
    node_slot.assign(mesh.n_nodes(), no_slot);
    hanging_nodes.clear();
  }

  template <int dim>
  void
  NodalFields<dim>::gather_nodes(const bool with_forces)
  {
    for (const auto *nodes : {&active_nodes, &hanging_nodes})
      for (const unsigned int node : *nodes)
        node_slot[node] = no_slot;
    active_nodes.clear();
    sums.clear();
    std::vector<unsigned int> at_hanging;
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      auto              &active  = this->template cells<Cell>();
      const unsigned int n_cells = active_cells.size();
      active.nodes.resize(n_cells);
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          if (mesh.has_hanging_vertex(active_cells[c]))
            {
              at_hanging.push_back(c);
              continue;
            }
          fetch_ahead(cells, active.sums, c);
          const Cell &cell  = cells[active_cells[c]];
          auto       &slots = active.nodes[c];
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            slots[k] = activate_node(cell.node[k]);
          add_cell(cell, active.sums[c], slots, with_forces, sums);
        }
    });
    gather_at_hanging(at_hanging, with_forces);
    spread.for_each_node([&](const unsigned int node, const auto &given) {
      add_scaled(sums[activate_node(node)], 1., given);
    });
    sum_nodes();
    hanging.reinit(active_nodes.size());
    hanging_nodes.clear();
    for (const unsigned int c : at_hanging)
      find_slots_of_vertices(c);
    motion.resize(active_nodes.size());
  }

  template <int dim>
  void
  NodalFields<dim>::gather_at_hanging(const std::vector<unsigned int> &slots,
                                      const bool with_forces)
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      std::array<unsigned int, Cell::n_nodes> in_order;
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        in_order[k] = k;
      std::vector<NodeSums<dim>> local;
      for (const unsigned int c : slots)
        {
          const Cell &cell = cells[active_cells[c]];
          local.assign(Cell::n_nodes, {});
          add_cell(cell,
                   this->template cells<Cell>().sums[c],
                   in_order,
                   with_forces,
                   local);
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            if (const auto *mean =
                  mesh.hanging_nodes().get_constraint_entries(cell.node[k]))
              for (const auto &[free, weight] : *mean)
                add_scaled(sums[activate_node(free)], weight, local[k]);
            else
              add_scaled(sums[activate_node(cell.node[k])], 1., local[k]);
        }
    });
  }

  template <int dim>
  void
  NodalFields<dim>::find_slots_of_vertices(const unsigned int slot)
  {
    mesh.visit([&](const auto &cells) {
      using Cell        = typename std::decay_t<decltype(cells)>::value_type;
      const Cell &cell  = cells[active_cells[slot]];
      auto       &slots = this->template cells<Cell>().nodes[slot];
      if (!mesh.has_hanging_vertex(active_cells[slot]))
        {
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            slots[k] = node_slot[cell.node[k]];
          return;
        }
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        {
          const unsigned int node = cell.node[k];
          const auto *mean = mesh.hanging_nodes().get_constraint_entries(node);
          const unsigned int place = node_slot[node] - active_nodes.size();
          const bool         is_new =
            mean != nullptr &&
            !(place < hanging_nodes.size() && hanging_nodes[place] == node);
          if (is_new)
            {
              HangingSlots::Mean of_slots;
              for (const auto &[free, weight] : *mean)
                of_slots.emplace_back(node_slot[free], weight);
              node_slot[node] = hanging.add(std::move(of_slots));
              hanging_nodes.push_back(node);
            }
          slots[k] = node_slot[node];
        }
    });
  }

  template <int dim>
  bool
  NodalFields<dim>::is_known_node(const unsigned int node) const
  {
    const auto *mean = mesh.hanging_nodes().get_constraint_entries(node);
    if (mean == nullptr)
      return is_active_node(node);
    for (const auto &entry : *mean)
      if (!is_active_node(entry.first))
        return false;
    return true;
  }

  template <int dim>
  void
  NodalFields<dim>::sum_nodes()
  {
    if (shared.is_serial())
      return;
    constexpr unsigned int n_values = 1 + 2 * dim;
    packed.resize(sums.size() * n_values);
    for (unsigned int i = 0; i < sums.size(); ++i)
      {
        double *values = packed.data() + i * n_values;
        *values++      = sums[i].mass;
        for (unsigned int d = 0; d < dim; ++d, ++values)
          {
            values[0]   = sums[i].momentum[d];
            values[dim] = sums[i].force[d];
          }
      }
    shared.find_and_sum(
      [&](const unsigned int node) {
        return is_active_node(node) ? node_slot[node] :
                                      SharedSums<dim>::no_slot;
      },
      [&](const unsigned int node) {
        if (partition.is_of_own_cell(node))
          activate_node(node);
      },
      packed,
      n_values);
    for (unsigned int i = 0; i < sums.size(); ++i)
      {
        const double *values = packed.data() + i * n_values;
        sums[i].mass         = *values++;
        for (unsigned int d = 0; d < dim; ++d, ++values)
          {
            sums[i].momentum[d] = values[0];
            sums[i].force[d]    = values[dim];
          }
      }
  }

  template <int dim>
  void
  NodalFields<dim>::activate_late(const unsigned int cell)
  {
    activate(cell);
    visit([](auto &cells) { cells.nodes.emplace_back(); });
    find_slots_of_vertices(active_cells.size() - 1);
  }

  template <int dim>
  void
  NodalFields<dim>::find_shared_cells(std::vector<double> &values,
                                      const unsigned int   n_values)
  {
    shared_cells.find_and_sum(
      [&](const unsigned int cell) { return cell_slot[cell]; },
      [&](const unsigned int cell) {
        if (partition.is_owned(cell) && !is_active_cell(cell))
          activate_late(cell);
      },
      values,
      n_values);
  }

  template <int dim>
  void
  NodalFields<dim>::gather_forces()
  {
    // Those of cells at hanging nodes first go there, then to the free nodes.
    const unsigned int n = active_nodes.size();
    for (auto &node : sums)
      node.force = 0.;
    sums.resize(n + hanging.size());
    mesh.visit([&](const auto &cells) {
      using Cell         = typename std::decay_t<decltype(cells)>::value_type;
      const auto &active = this->template cells<Cell>();
      for (unsigned int c = 0; c < active_cells.size(); ++c)
        Grid::add_forces(cells[active_cells[c]],
                         active.sums[c].internal,
                         active.nodes[c],
                         sums);
    });
    for (unsigned int slot = n; slot < sums.size(); ++slot)
      hanging.add_at(sums, slot, NodeSums<dim>(sums[slot]));
    sums.resize(n);
    spread.for_each_node([&](const unsigned int node, const auto &given) {
      sums[node_slot[node]].force += given.force;
    });
    if (shared.is_serial())
      return;
    partial.resize(sums.size());
    for (unsigned int i = 0; i < sums.size(); ++i)
      partial[i] = sums[i].force;
    shared.sum(partial);
    for (unsigned int i = 0; i < sums.size(); ++i)
      sums[i].force = partial[i];
  }

  namespace
  {
    template <int dim>
    Lanes
    as_lanes(const Tensor<1, dim> &vector)
    {
      return Lanes(vector[0], vector[1], dim == 3 ? vector[dim - 1] : 0., 0.);
    }

    template <int dim>
    Tensor<1, dim>
    as_tensor(const Lanes &lanes)
    {
      Tensor<1, dim> vector;
      for (unsigned int d = 0; d < dim; ++d)
        vector[d] = lanes.data[d];
      return vector;
    }

    /// Adds the mass matrix of a cell times the values at its nodes to the
    /// products, with a lane for each component: half of the time of numbers
    /// one by one.
    template <class CellMass, std::size_t n_nodes, class Product>
    inline void
    multiply(const CellMass                          &mass,
             const std::array<unsigned int, n_nodes> &nodes,
             std::vector<Product>                    &products)
    {
      Lanes value[n_nodes];
      for (unsigned int k = 0; k < n_nodes; ++k)
        value[k] = products[nodes[k]].value;
      for (unsigned int k = 0; k < n_nodes; ++k)
        {
          Lanes sum = mass(k, 0) * value[0];
          for (unsigned int j = 1; j < n_nodes; ++j)
            sum += mass(k, j) * value[j];
          products[nodes[k]].product += sum;
        }
    }
  } // namespace

  template <int dim>
  void
  NodalFields<dim>::add_mass_times(const std::vector<Tensor<1, dim>> &field,
                                   std::vector<Tensor<1, dim>>       &result)
  {
    auto &sum_here = shared.is_serial() ? result : partial;
    if (!shared.is_serial())
      partial.assign(field.size(), Tensor<1, dim>());

    const unsigned int n = field.size();
    products.resize(n + hanging.size());
    for (unsigned int i = 0; i < products.size(); ++i)
      products[i] = {as_lanes(hanging.value_at(field, i)), 0.};
    visit([&](const auto &active) {
      for (unsigned int c = 0; c < active_cells.size(); ++c)
        multiply(active.sums[c].mass, active.nodes[c], products);
    });
    for (unsigned int i = 0; i < products.size(); ++i)
      hanging.add_at(sum_here, i, as_tensor<dim>(products[i].product));

    spread.add_mass_times(
      [&](const unsigned int node) { return node_slot[node]; },
      field,
      sum_here);
    if (shared.is_serial())
      return;
    shared.sum(partial);
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] += partial[i];
  }

  template <int dim>
  void
  NodalFields<dim>::serialize(Core::Archive &archive)
  {
    if (archive.is_reading())
      clear_cells();
    if (partition.acts_beyond_cells)
      spread.serialize(archive);
    archive.distributed("grid/active_cells", active_cells);
    visit([&](auto &cells) {
      using Sums = typename std::decay_t<decltype(cells.sums)>::value_type;
      constexpr unsigned int n_numbers = sizeof(Sums) / sizeof(double);
      static_assert(std::is_trivially_copyable_v<Sums> &&
                      sizeof(Sums) == n_numbers * sizeof(double),
                    "the sums of a cell are copied as so many numbers");
      std::vector<double> numbers(n_numbers * cells.sums.size());
      if (!cells.sums.empty())
        std::memcpy(numbers.data(),
                    cells.sums.data(),
                    numbers.size() * sizeof(double));
      archive.distributed("grid/cell_sums", numbers, n_numbers);

      if (!archive.is_reading())
        return;
      cells.sums.resize(active_cells.size());
      if (!cells.sums.empty())
        std::memcpy(cells.sums.data(),
                    numbers.data(),
                    numbers.size() * sizeof(double));
      for (unsigned int slot = 0; slot < active_cells.size(); ++slot)
        cell_slot[active_cells[slot]] = slot;
    });
  }

  template <int dim>
  std::size_t
  NodalFields<dim>::memory_consumption() const
  {
    return (cell_slot.capacity() + node_slot.capacity() +
            active_cells.capacity() + active_nodes.capacity()) *
             sizeof(unsigned int) +
           std::visit(
             [](const auto &cells) {
               return cells.sums.capacity() * sizeof(cells.sums[0]) +
                      cells.nodes.capacity() * sizeof(cells.nodes[0]);
             },
             all_cells) +
           spread.memory_consumption() +
           sums.capacity() * sizeof(NodeSums<dim>) +
           products.capacity() * sizeof(Product) +
           motion.capacity() * sizeof(NodeMotion<dim>);
  }

  template class NodalFields<2>;
  template class NodalFields<3>;
} // namespace mpm_granular::Grid
