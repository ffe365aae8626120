#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/transfer/node_averaging.h>
#include <mpm_granular/transfer/stress_power.h>
#include <mpm_granular/transfer/sum_by_cell.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  NodeAveraging<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Averaged part",
                      averaged_part,
                      "Part of stresses and gradients that is averaged around "
                      "nodes; the rest is taken from each cell alone and "
                      "steadies what the averages do not see. Units: -.",
                      Patterns::Double(0., 1.));
  }

  template <int dim>
  bool
  NodeAveraging<dim>::suit(const BodyTraits &body)
  {
    makes_room = body.is_granular && body.points_per_cell < few_points_per_cell;
    return false;
  }

  template <int dim>
  void
  NodeAveraging<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh,
                             const Mesh::Partition<dim>      &new_partition,
                             const std::vector<double> &largest_specific_volume)
  {
    require(new_mesh.cell_kind() == Mesh::CellKind::simplex,
            "Scheme/Averaging: means around nodes are made on simplices only; "
            "on hypercubes it must be 'none' or 'cells'.");
    mesh      = &new_mesh;
    partition = &new_partition;
    filling.reinit(*mesh, *partition, largest_specific_volume);
    clear();

    const auto lowest_node = [&](const unsigned int cell) {
      return mesh->free_nodes(cell).front();
    };
    first_cell.assign(mesh->n_nodes() + 1, 0);
    for (unsigned int cell = 0; cell < mesh->n_cells(); ++cell)
      ++first_cell[lowest_node(cell) + 1];
    for (unsigned int node = 0; node < mesh->n_nodes(); ++node)
      first_cell[node + 1] += first_cell[node];
    auto next = first_cell;
    cells_of_node.resize(mesh->n_cells());
    for (unsigned int cell = 0; cell < mesh->n_cells(); ++cell)
      cells_of_node[next[lowest_node(cell)]++] = cell;
  }

  template <int dim>
  void
  NodeAveraging<dim>::clear()
  {
    filling.clear();
    clear_stresses();
  }

  template <int dim>
  void
  NodeAveraging<dim>::clear_stresses()
  {
    parts.clear();
  }

  template <int dim>
  void
  NodeAveraging<dim>::add_volumes(const Points::PointArrays<dim> &points,
                                  const PointBlock<dim>          &block,
                                  const Grid::NodalFields<dim>   &fields)
  {
    filling.add(points, block, fields);
  }

  template <int dim>
  void
  NodeAveraging<dim>::add_stresses(const Points::PointArrays<dim> &points,
                                   const PointBlock<dim>          &block,
                                   Grid::NodalFields<dim>         &fields)
  {
    using StressParts = std::array<std::array<double, n_nodes>, n_stress<dim>>;
    parts.resize(fields.active_cells.size() * n_parts);
    sum_by_cell<StressParts>(
      block,
      [&](const unsigned int p, StressParts &sums) {
        double share[n_nodes];
        for (unsigned int k = 0; k < n_nodes; ++k)
          share[k] = points.volume[p] * block.shape_values[k][p - block.begin];
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          for (unsigned int k = 0; k < n_nodes; ++k)
            sums[s][k] += share[k] * points.stress[s][p];
      },
      [&](const unsigned int cell, const StressParts &sums) {
        if (cell == Mesh::no_cell)
          return;
        double *total = parts.data() + fields.slot_of_cell(cell) * n_parts;
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          for (unsigned int k = 0; k < n_nodes; ++k)
            total[s * n_nodes + k] += sums[s][k];
      });
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_forces(Grid::NodalFields<dim> &fields)
  {
    sum_stresses(fields);
    const auto is_full = filling.full_nodes(fields);
    auto      &active  = fields.template cells<Cell>();
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        Stress<dim> &total = active.sums[c].internal.stress;
        if (cell_weights[c] == 0.)
          {
            total = {};
            continue;
          }
        const auto &nodes    = active.nodes[c];
        bool        all_full = true;
        for (const unsigned int node : nodes)
          all_full &= is_full[node] != 0;
        const double                     volume = filling.of_cell(c);
        std::array<Stress<dim>, n_nodes> at_nodes;
        for (unsigned int k = 0; k < n_nodes; ++k)
          at_nodes[k] = fields.hanging.value_at(stresses, nodes[k]);
        const double own_factor =
          (1. - averaged_part) *
          (all_full && volume > 0. ?
             mesh->cell_volume(fields.active_cells[c]) / volume :
             1.);
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          {
            double own = 0., around = 0.;
            for (unsigned int k = 0; k < n_nodes; ++k)
              {
                own += parts[c * n_parts + s * n_nodes + k];
                around += at_nodes[k][s];
              }
            total[s] =
              own_factor * own + averaged_part * cell_weights[c] * around;
          }
      }
    fields.gather_forces();
  }

  template <int dim>
  void
  NodeAveraging<dim>::activate_enclosed(Grid::NodalFields<dim> &fields) const
  {
    const auto is_known = [&](const unsigned int node) {
      return fields.is_known_node(node);
    };
    for (const unsigned int node : fields.active_nodes)
      for (unsigned int i = first_cell[node]; i < first_cell[node + 1]; ++i)
        {
          const unsigned int cell = cells_of_node[i];
          if (fields.is_active_cell(cell) || !partition->is_owned(cell))
            continue;
          const auto nodes = mesh->nodes(cell);
          if (std::all_of(nodes.begin(), nodes.end(), is_known))
            fields.activate_late(cell);
        }
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_weights(Grid::NodalFields<dim> &fields)
  {
    filling.sum(fields);
    activate_enclosed(fields);

    // Cells in surroundings that are not full count less, down to hardly.
    constexpr double least  = 1e-12;
    const auto      &active = fields.template cells<Cell>();
    cell_weights.resize(fields.active_cells.size());
    node_weights.assign(fields.n_active_nodes(), 0.);
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        double fraction = 1.;
        for (const unsigned int node : active.nodes[c])
          fraction =
            std::min(fraction,
                     filling.fraction(fields, node) / Filling<dim>::full);
        const unsigned int cell = fields.active_cells[c];
        cell_weights[c] =
          partition->is_owned(cell) ?
            mesh->cell_volume(cell) * std::max(fraction, least) :
            0.;
        for (const unsigned int node : active.nodes[c])
          fields.hanging.add_at(node_weights, node, cell_weights[c]);
      }
    fields.shared.sum(node_weights.data(), 1);
  }

  template <int dim>
  void
  NodeAveraging<dim>::sum_stresses(Grid::NodalFields<dim> &fields)
  {
    const auto &active = fields.template cells<Cell>();
    parts.resize(active.nodes.size() * n_parts);
    fields.shared_cells.sum(parts.data(), n_parts);
    stresses.assign(fields.n_active_nodes(), {});
    for (unsigned int c = 0; c < active.nodes.size(); ++c)
      if (partition->is_owned(fields.active_cells[c]))
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            Stress<dim> part;
            for (unsigned int s = 0; s < n_stress<dim>; ++s)
              part[s] = parts[c * n_parts + s * n_nodes + k];
            fields.hanging.add_at(stresses, active.nodes[c][k], part);
          }
    fields.shared.sum(stresses);

    // Where the surroundings are full the stress acts on their whole volume;
    // where they are about empty, on that of the points.
    constexpr double half_full = Filling<dim>::full - 0.2;
    stress_factors.resize(stresses.size());
    for (unsigned int i = 0; i < stresses.size(); ++i)
      {
        const double theta = filling.fraction(fields, i);
        const double part =
          std::clamp((theta - half_full) / (Filling<dim>::full - half_full),
                     0.,
                     1.);
        stress_factors[i] = (1. + part * (1. / theta - 1.)) / node_weights[i];
        for (double &component : stresses[i])
          component *= stress_factors[i];
      }
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_gradients(Grid::NodalFields<dim> &fields)
  {
    const auto &cells  = mesh->template cells<Cell>();
    const auto &active = fields.template cells<Cell>();
    gradients.assign(fields.n_active_nodes(), {});
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        if (cell_weights[c] == 0.)
          continue;
        const Cell &cell  = cells[fields.active_cells[c]];
        const auto &nodes = active.nodes[c];
        auto        part  = straining_gradient(cell, nodes, fields);
        for (double &component : part)
          component *= cell_weights[c];
        for (const unsigned int node : nodes)
          fields.hanging.add_at(gradients, node, part);
      }
    fields.shared.sum(gradients);
    for (unsigned int node = 0; node < gradients.size(); ++node)
      for (double &component : gradients[node])
        component /= node_weights[node];
    fields.hanging.extend(gradients);
  }

  template <int dim>
  void
  NodeAveraging<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                               const Points::PointArrays<dim> &points,
                               PointBlock<dim>                &block) const
  {
    const auto &cells = mesh->template cells<Cell>();
    block.gradients.clear();
    block.strained.clear();
    for (const auto &run : block.runs)
      {
        const Cell                       &cell = cells[points.cell[run.begin]];
        std::array<unsigned int, n_nodes> nodes;
        for (unsigned int k = 0; k < n_nodes; ++k)
          nodes[k] = fields.slot_of(cell.node[k]);

        // L(x) = value + slope_d (x - x_0)_d
        std::array<double, dim * dim>                  value{};
        std::array<std::array<double, dim * dim>, dim> slope{};
        const auto &first_velocity = fields.motion[nodes[0]].straining;
        const auto &first          = gradients[nodes[0]];
        for (unsigned int i = 0; i < dim * dim; ++i)
          value[i] = averaged_part * first[i];
        for (unsigned int k = 0; k < dim; ++k)
          {
            const auto &velocity = fields.motion[nodes[k + 1]].straining;
            const auto &other    = gradients[nodes[k + 1]];
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                value[i * dim + j] += (1. - averaged_part) *
                                      (velocity[i] - first_velocity[i]) *
                                      cell.gradient[k][j];
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int i = 0; i < dim * dim; ++i)
                slope[d][i] +=
                  averaged_part * (other[i] - first[i]) * cell.gradient[k][d];
          }

        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            std::array<double, dim *dim> at_point = value;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double offset = points.position[d][p] - cell.origin[d];
                for (unsigned int i = 0; i < dim * dim; ++i)
                  at_point[i] += slope[d][i] * offset;
              }
            Tensor<2, dim> gradient;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                gradient[i][j] = at_point[i * dim + j];
            block.gradients.push_back(gradient);
            block.strained.push_back({p, p + 1});
          }
      }
  }

  template <int dim>
  double
  NodeAveraging<dim>::lost_power(const Grid::NodalFields<dim> &fields) const
  {
    const auto &cells  = mesh->template cells<Cell>();
    const auto &active = fields.template cells<Cell>();
    double      power  = 0.;
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        if (cell_weights[c] == 0.)
          continue;
        Stress<dim> stress = active.sums[c].internal.stress;
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          for (unsigned int k = 0; k < n_nodes; ++k)
            stress[s] -=
              (1. - averaged_part) * parts[c * n_parts + s * n_nodes + k];
        power +=
          stress_power<dim>(stress,
                            straining_gradient(cells[fields.active_cells[c]],
                                               active.nodes[c],
                                               fields));
      }
    for (unsigned int i = 0; i < stresses.size(); ++i)
      if (fields.shared.counts(i))
        power -= averaged_part / stress_factors[i] *
                 stress_power<dim>(stresses[i], gradients[i]);
    return power;
  }

  template <int dim>
  void
  NodeAveraging<dim>::serialize(Core::Archive &archive)
  {
    filling.serialize(archive);
    archive.distributed("averaging/stresses", parts, n_parts);
  }

  template class NodeAveraging<2>;
  template class NodeAveraging<3>;

  namespace
  {
    const std::string documentation =
      "gradients are means over the cells around nodes, and forces do the same "
      "work: steady where points cross cells, and one point per cell is "
      "enough.";
    const AveragingRegistry<2>::Entry<NodeAveraging<2>> nodes_2d("nodes",
                                                                 documentation);
    const AveragingRegistry<3>::Entry<NodeAveraging<3>> nodes_3d("nodes",
                                                                 documentation);
  } // namespace
} // namespace mpm_granular::Transfer
