#include <mpm_granular/grid/nodal_fields.h>

#include <cstring>
#include <type_traits>

namespace mpm_granular::Grid
{
  using namespace dealii;

  template <int dim>
  NodalFields<dim>::NodalFields(const Mesh::BackgroundMesh<dim> &mesh,
                                const Mesh::Partition<dim>      &partition)
    : shared(partition)
    , mesh(mesh)
    , cell_slot(mesh.n_cells(), 0)
    , node_slot(mesh.n_nodes(), 0)
  {}

  template <int dim>
  void
  NodalFields<dim>::activate_nodes()
  {
    active_nodes.clear();
    cell_nodes.resize(active_cells.size());
    for (unsigned int c = 0; c < active_cells.size(); ++c)
      for (unsigned int k = 0; k <= dim; ++k)
        {
          const unsigned int node = mesh.cell(active_cells[c]).node[k];
          if (!is_active_node(node))
            {
              node_slot[node] = active_nodes.size();
              active_nodes.push_back(node);
            }
          cell_nodes[c][k] = node_slot[node];
        }
    sums.assign(active_nodes.size(), {});
    motion.resize(active_nodes.size());
  }

  template <int dim>
  void
  NodalFields<dim>::gather_nodes()
  {
    activate_nodes();
    for (unsigned int c = 0; c < active_cells.size(); ++c)
      {
        const CellSums<dim> &cell = cell_sums[c];
        for (unsigned int k = 0; k <= dim; ++k)
          {
            NodeSums<dim> &node = sums[cell_nodes[c][k]];
            for (unsigned int j = 0; j <= dim; ++j)
              node.mass += cell.mass[k * (dim + 1) + j];
            for (unsigned int d = 0; d < dim; ++d)
              node.momentum[d] += cell.momentum[d][k];
          }
      }
    add_forces();
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
                                      SharedNodes<dim>::no_slot;
      },
      sums.size(),
      packed.data(),
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
  NodalFields<dim>::gather_forces()
  {
    for (auto &node : sums)
      node.force = 0.;
    add_forces();
    if (shared.is_serial())
      return;
    partial.resize(sums.size());
    for (unsigned int i = 0; i < sums.size(); ++i)
      partial[i] = sums[i].force;
    shared.sum(partial);
    for (unsigned int i = 0; i < sums.size(); ++i)
      sums[i].force = partial[i];
  }

  template <int dim>
  void
  NodalFields<dim>::add_forces()
  {
    for (unsigned int c = 0; c < active_cells.size(); ++c)
      {
        const auto    &geometry = mesh.cell(active_cells[c]);
        const auto    &stress   = cell_sums[c].stress;
        Tensor<2, dim> sigma; // sum_p V_p sigma_p
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          {
            const unsigned int i = stress_index[s][0], j = stress_index[s][1];
            if (i < dim && j < dim)
              sigma[i][j] = sigma[j][i] = stress[s];
          }
        Tensor<1, dim> rest; // forces in a cell add up to zero
        for (unsigned int k = 0; k < dim; ++k)
          {
            Tensor<1, dim> force;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                force[i] -= sigma[i][j] * geometry.gradient[k][j];
            sums[cell_nodes[c][k + 1]].force += force;
            rest -= force;
          }
        sums[cell_nodes[c][0]].force += rest;
      }
  }

  template <int dim>
  void
  NodalFields<dim>::add_mass_times(const std::vector<Tensor<1, dim>> &field,
                                   std::vector<Tensor<1, dim>>       &result)
  {
    auto &sum_here = shared.is_serial() ? result : partial;
    if (!shared.is_serial())
      partial.assign(field.size(), Tensor<1, dim>());
    for (unsigned int c = 0; c < active_cells.size(); ++c)
      {
        const auto                         &mass  = cell_sums[c].mass;
        const auto                         &nodes = cell_nodes[c];
        std::array<Tensor<1, dim>, dim + 1> local;
        for (unsigned int k = 0; k <= dim; ++k)
          local[k] = field[nodes[k]];
        for (unsigned int k = 0; k <= dim; ++k)
          {
            Tensor<1, dim> sum;
            for (unsigned int j = 0; j <= dim; ++j)
              sum += mass[k * (dim + 1) + j] * local[j];
            sum_here[nodes[k]] += sum;
          }
      }
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
    constexpr unsigned int n_numbers = sizeof(CellSums<dim>) / sizeof(double);
    static_assert(std::is_trivially_copyable_v<CellSums<dim>> &&
                    sizeof(CellSums<dim>) == n_numbers * sizeof(double),
                  "the sums of a cell are copied as so many numbers");
    archive.distributed("grid/active_cells", active_cells);
    std::vector<double> numbers(n_numbers * cell_sums.size());
    if (!cell_sums.empty())
      std::memcpy(numbers.data(),
                  cell_sums.data(),
                  numbers.size() * sizeof(double));
    archive.distributed("grid/cell_sums", numbers, n_numbers);

    if (!archive.is_reading())
      return;
    cell_sums.resize(active_cells.size());
    if (!cell_sums.empty())
      std::memcpy(cell_sums.data(),
                  numbers.data(),
                  numbers.size() * sizeof(double));
    for (unsigned int slot = 0; slot < active_cells.size(); ++slot)
      cell_slot[active_cells[slot]] = slot;
  }

  template <int dim>
  std::size_t
  NodalFields<dim>::memory_consumption() const
  {
    return (cell_slot.capacity() + node_slot.capacity() +
            active_cells.capacity() + active_nodes.capacity()) *
             sizeof(unsigned int) +
           cell_sums.capacity() * sizeof(CellSums<dim>) +
           cell_nodes.capacity() * sizeof(CellNodes) +
           sums.capacity() * sizeof(NodeSums<dim>) +
           motion.capacity() * sizeof(NodeMotion<dim>);
  }

  template class NodalFields<2>;
  template class NodalFields<3>;
} // namespace mpm_granular::Grid
