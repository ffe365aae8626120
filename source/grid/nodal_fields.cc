#include <mpm_granular/grid/nodal_fields.h>

namespace mpm_granular::Grid
{
  using namespace dealii;

  template <int dim>
  NodalFields<dim>::NodalFields(const Mesh::BackgroundMesh<dim> &mesh)
    : mesh(mesh)
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
    gather_forces();
  }

  template <int dim>
  void
  NodalFields<dim>::gather_forces()
  {
    for (auto &node : sums)
      node.force = 0.;
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
                                   std::vector<Tensor<1, dim>> &result) const
  {
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
            result[nodes[k]] += sum;
          }
      }
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
