#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/transfer/node_averaging.h>
#include <mpm_granular/transfer/stress_power.h>
#include <mpm_granular/transfer/sum_by_cell.h>

#include <algorithm>
#include <cstring>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// Component @p s of a stress in lanes.
    template <std::size_t n>
    double
    component(const std::array<Lanes, n> &stress, const unsigned int s)
    {
      return stress[s / Lanes::n].data[s % Lanes::n];
    }
  } // namespace

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
      cells_of_node[next[lowest_node(cell)]++] = {
        cell, mesh->template cells<Cell>()[cell].node};
    is_known.assign(mesh->n_nodes(), false);
    is_empty.assign(mesh->n_cells(), true);
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
    sum_by_cell<StressParts>(
      block,
      [&](const unsigned int p, StressParts &sums) {
        const auto stress_of = [&](const unsigned int s) {
          return s < n_stress<dim> ? points.stress[s][p] : 0.;
        };
        StressLanes stress;
        for (unsigned int l = 0, s = 0; l < stress.size(); ++l, s += Lanes::n)
          stress[l] = Lanes(stress_of(s),
                            stress_of(s + 1),
                            stress_of(s + 2),
                            stress_of(s + 3));
        for (unsigned int k = 0; k < n_nodes; ++k)
          add_scaled(sums[k],
                     points.volume[p] * block.shape_values[k][p - block.begin],
                     stress);
      },
      [&](const unsigned int cell, const StressParts &sums) {
        if (cell == Mesh::no_cell)
          return;
        // What is new is not read right after it was written.
        const std::size_t place  = fields.slot_of_cell(cell);
        const bool        is_new = place >= parts.size();
        if (is_new)
          parts.resize(place + 1);
        StressParts &total = parts[place];
        for (unsigned int k = 0; k < n_nodes; ++k)
          for (unsigned int l = 0; l < total[k].size(); ++l)
            total[k][l] = is_new ? sums[k][l] : total[k][l] + sums[k][l];
      });
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_forces(Grid::NodalFields<dim> &fields)
  {
    sum_stresses(fields);
    auto &active = fields.template cells<Cell>();
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        Stress<dim> &total = active.sums[c].internal.stress;
        if (cell_weights[c] == 0.)
          {
            total = {};
            continue;
          }
        StressLanes around{};
        for (const unsigned int node : active.nodes[c])
          add_scaled(around, 1., stresses[node]);
        StressLanes sum{};
        add_scaled(sum, averaged_part * cell_weights[c], around);
        if (c < n_cells_with_points)
          add_scaled(sum,
                     (1. - averaged_part) * own_factors[c],
                     own_stresses[c]);
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          total[s] = component(sum, s);
      }
    fields.gather_forces();
  }

  template <int dim>
  void
  NodeAveraging<dim>::activate_enclosed(Grid::NodalFields<dim> &fields)
  {
    const auto mark = [&](const bool value) {
      for (const unsigned int node : fields.active_nodes)
        is_known[node] = value;
      for (const auto &line : mesh->hanging_nodes().get_lines())
        is_known[line.index] = value && fields.is_known_node(line.index);
      for (unsigned int c = 0; c < n_cells_with_points; ++c)
        is_empty[fields.active_cells[c]] = !value;
    };
    mark(true);

    // Whether a cell is one of them cannot be predicted: no branch depends on
    // it.
    std::vector<unsigned int> found;
    for (const unsigned int node : fields.active_nodes)
      {
        const unsigned int begin = first_cell[node], end = first_cell[node + 1];
        unsigned int       n_found = 0;
        if (found.size() < end - begin)
          found.resize(end - begin);
        for (unsigned int i = begin; i < end; ++i)
          {
            const auto  &cell   = cells_of_node[i];
            std::uint8_t is_new = is_empty[cell.index];
            for (const unsigned int vertex : cell.node)
              is_new &= is_known[vertex];
            found[n_found] = cell.index;
            n_found += is_new;
          }
        for (unsigned int i = 0; i < n_found; ++i)
          if (partition->is_owned(found[i]))
            fields.activate_late(found[i]);
      }
    mark(false);
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_weights(Grid::NodalFields<dim> &fields)
  {
    filling.sum(fields);
    n_cells_with_points = fields.active_cells.size();
    activate_enclosed(fields);

    // Cells in surroundings that are not full count less, down to hardly.
    constexpr double least        = 1e-12;
    constexpr double part_of_full = 1. / Filling<dim>::full;
    const auto      &active       = fields.template cells<Cell>();
    cell_weights.resize(fields.active_cells.size());
    own_factors.resize(fields.active_cells.size());
    node_weights.assign(fields.n_active_nodes(), 0.);
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        double fraction = filling.fraction(fields, active.nodes[c][0]);
        for (const unsigned int node : active.nodes[c])
          fraction = std::min(fraction, filling.fraction(fields, node));
        const unsigned int cell   = fields.active_cells[c];
        const double       volume = filling.of_cell(c);
        const double       whole  = mesh->cell_volume(cell);
        const bool is_full = (fraction > Filling<dim>::full) & (volume > 0.);
        own_factors[c]     = whole / (is_full ? volume : whole);
        cell_weights[c] =
          partition->is_owned(cell) ?
            whole * std::clamp(fraction * part_of_full, least, 1.) :
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
    parts.resize(n_cells_with_points);
    fields.shared_cells.sum(reinterpret_cast<double *>(parts.data()), n_parts);
    stresses.assign(fields.n_active_nodes(), {});
    own_stresses.resize(parts.size());
    for (unsigned int c = 0; c < parts.size(); ++c)
      {
        StressLanes &own = own_stresses[c] = parts[c][0];
        for (unsigned int k = 1; k < n_nodes; ++k)
          add_scaled(own, 1., parts[c][k]);
        if (partition->is_owned(fields.active_cells[c]))
          for (unsigned int k = 0; k < n_nodes; ++k)
            fields.hanging.add_at(stresses, active.nodes[c][k], parts[c][k]);
      }
    fields.shared.sum(stresses);

    // Where the surroundings are full the stress acts on their whole volume;
    // where they are about empty, on that of the points.
    constexpr double half_full = Filling<dim>::full - 0.2;
    stress_factors.resize(node_weights.size());
    for (unsigned int i = 0; i < node_weights.size(); ++i)
      {
        const double theta = filling.fraction(fields, i);
        const double part =
          std::clamp((theta - half_full) / (Filling<dim>::full - half_full),
                     0.,
                     1.);
        stress_factors[i] = (1. + part * (1. / theta - 1.)) / node_weights[i];
        for (Lanes &lanes : stresses[i])
          lanes = lanes * stress_factors[i];
      }
    fields.hanging.extend(stresses);
  }

  template <int dim>
  void
  NodeAveraging<dim>::find_gradients(Grid::NodalFields<dim> &fields)
  {
    const auto &cells  = mesh->template cells<Cell>();
    const auto &active = fields.template cells<Cell>();
    gradients.assign(fields.n_active_nodes(), {});
    cell_gradients.resize(cell_weights.size());
    for (unsigned int c = 0; c < cell_weights.size(); ++c)
      {
        if (cell_weights[c] == 0.)
          continue;
        const auto &nodes = active.nodes[c];
        cell_gradients[c] =
          straining_gradient(cells[fields.active_cells[c]], nodes, fields);
        VelocityGradient<dim> part{};
        add_scaled(part, cell_weights[c], cell_gradients[c]);
        for (const unsigned int node : nodes)
          fields.hanging.add_at(gradients, node, part);
      }
    fields.shared.sum(gradients);
    for (unsigned int node = 0; node < gradients.size(); ++node)
      {
        const double factor = 1. / node_weights[node];
        for (Lanes &lanes : gradients[node])
          lanes = lanes * factor;
      }
    fields.hanging.extend(gradients);
  }

  template <int dim>
  void
  NodeAveraging<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                               const Points::PointArrays<dim> &points,
                               PointBlock<dim>                &block) const
  {
    const auto &cells = mesh->template cells<Cell>();
    block.gradients.resize(block.end - block.begin);
    block.strained.resize(block.end - block.begin);
    for (const auto &run : block.runs)
      {
        const Cell                       &cell = cells[points.cell[run.begin]];
        std::array<unsigned int, n_nodes> nodes;
        for (unsigned int k = 0; k < n_nodes; ++k)
          nodes[k] = fields.slot_of(cell.node[k]);
        VelocityGradient<dim> own{};
        add_scaled(own,
                   1. - averaged_part,
                   straining_gradient(cell, nodes, fields));

        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            const auto shape_values = cell.shape_values(points.location(p));
            VelocityGradient<dim> at_point = own;
            for (unsigned int k = 0; k < n_nodes; ++k)
              add_scaled(at_point,
                         averaged_part * shape_values[k],
                         gradients[nodes[k]]);

            Tensor<2, dim> &gradient = block.gradients[p - block.begin];
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                gradient[i][j] = derivative<dim>(at_point, i, j);
            block.strained[p - block.begin] = {p, p + 1};
          }
      }
  }

  template <int dim>
  double
  NodeAveraging<dim>::lost_power(const Grid::NodalFields<dim> &fields) const
  {
    // What forces take is T_e : L_e, summed over the cells; with (T42) and
    // (T43) only what the factors c change is left of the difference.
    double power = 0.;
    for (unsigned int c = 0; c < n_cells_with_points; ++c)
      if (cell_weights[c] != 0. && own_factors[c] != 1.)
        power +=
          (1. - averaged_part) * (own_factors[c] - 1.) *
          stress_power<dim>(
            [&](const unsigned int s) { return component(own_stresses[c], s); },
            cell_gradients[c]);
    for (unsigned int i = 0; i < node_weights.size(); ++i)
      if (fields.shared.counts(i))
        power +=
          averaged_part * (node_weights[i] - 1. / stress_factors[i]) *
          stress_power<dim>(
            [&](const unsigned int s) { return component(stresses[i], s); },
            gradients[i]);
    return power;
  }

  template <int dim>
  void
  NodeAveraging<dim>::serialize(Core::Archive &archive)
  {
    filling.serialize(archive);
    std::vector<double> numbers(parts.size() * n_parts);
    if (!parts.empty())
      std::memcpy(numbers.data(),
                  parts.data(),
                  numbers.size() * sizeof(double));
    archive.distributed("averaging/stress_parts", numbers, n_parts);
    parts.resize(numbers.size() / n_parts);
    if (!parts.empty())
      std::memcpy(parts.data(),
                  numbers.data(),
                  numbers.size() * sizeof(double));
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
