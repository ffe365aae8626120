#include <mpm_granular/transfer/pressure_filter.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  PressureFilter<dim>::PressureFilter(const Mesh::BackgroundMesh<dim> &mesh)
    : mesh(mesh)
  {}



  template <int dim>
  void
  PressureFilter<dim>::reinit(const Grid::NodalFields<dim> &fields)
  {
    means.assign(fields.n_active_nodes(), {});
    slopes.assign(fields.n_active_nodes(), {});
    cell_volume.assign(fields.active_cells.size(), 0.);
  }



  template <int dim>
  void
  PressureFilter<dim>::add(const Grid::NodalFields<dim>   &fields,
                           const Points::PointArrays<dim> &points,
                           const Points::Run               run)
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      const Cell        &cell  = cells[points.cell[run.begin]];
      const unsigned int slot  = fields.slot_of_cell(points.cell[run.begin]);
      const auto        &slots = fields.template cells<Cell>().nodes[slot];
      for (unsigned int p = run.begin; p < run.end; ++p)
        {
          const double point_pressure = points.pressure(p);
          if (point_pressure <= 0.)
            continue;
          const double     point_volume = points.volume[p];
          const Point<dim> x            = points.location(p);
          const auto       shape_values = cell.shape_values(x);
          cell_volume[slot] += point_volume;
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            {
              const double share = shape_values[k] * point_volume;
              std::array<double, n_means> part;
              part[volume]   = share;
              part[pressure] = share * point_pressure;
              for (unsigned int d = 0; d < dim; ++d)
                part[center + d] = share * x[d];
              fields.hanging.add_at(means, slots[k], part);
            }
        }
    });
  }



  template <int dim>
  void
  PressureFilter<dim>::find_gradients(Grid::NodalFields<dim> &fields)
  {
    fields.shared.sum(means);
    fields.hanging.extend(means);
    for (auto &node : means)
      if (node[volume] > 0.)
        for (unsigned int m = pressure; m < n_means; ++m)
          node[m] /= node[volume];

    // The simplex of the centers of its nodes, where it is not too flat a
    // picture of the cell, has a gradient of the mean pressures.
    constexpr double flattest = dim == 2 ? 0.2 : 0.1;
    mesh.visit([&](const auto &cells) {
      using Cell         = typename std::decay_t<decltype(cells)>::value_type;
      const auto &active = fields.template cells<Cell>();
      for (unsigned int c = 0; c < cell_volume.size(); ++c)
        {
          const auto &slots      = active.nodes[c];
          const auto  is_sampled = [&](const unsigned int slot) {
            return means[slot][volume] > 0.;
          };
          if (cell_volume[c] == 0. ||
              !std::all_of(slots.begin(), slots.end(), is_sampled))
            continue;
          Tensor<2, dim> map; // from the cell to the centers of its nodes
          Tensor<1, dim> along_cell;
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            {
              const auto          &node = means[slots[k]];
              const Tensor<1, dim> shape_gradient =
                cells[fields.active_cells[c]].central_gradient(k);
              for (unsigned int d = 0; d < dim; ++d)
                map[d] += node[center + d] * shape_gradient;
              along_cell += node[pressure] * shape_gradient;
            }
          if (determinant(map) <= flattest)
            continue;
          const Tensor<1, dim> in_space = transpose(invert(map)) * along_cell;
          std::array<double, n_slopes> part;
          part[weight] = cell_volume[c];
          for (unsigned int d = 0; d < dim; ++d)
            part[gradient + d] = cell_volume[c] * in_space[d];
          for (const unsigned int slot : slots)
            fields.hanging.add_at(slopes, slot, part);
        }
    });
    fields.shared.sum(slopes);
    fields.hanging.extend(slopes);
    for (auto &node : slopes)
      if (node[weight] > 0.)
        for (unsigned int d = 0; d < dim; ++d)
          node[gradient + d] /= node[weight];
  }



  template <int dim>
  void
  PressureFilter<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                                const Points::PointArrays<dim> &points,
                                const Points::Run               run,
                                std::vector<double> &smooth_pressure) const
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      const Cell        &cell = cells[points.cell[run.begin]];
      const unsigned int slot_of_cell =
        fields.slot_of_cell(points.cell[run.begin]);
      const auto &slots = fields.template cells<Cell>().nodes[slot_of_cell];

      // Where all cells around a node are too poor in points for a gradient,
      // that of the other nodes of the cell stands in.
      std::array<std::array<double, dim>, Cell::n_nodes> gradients{};
      std::array<double, dim>                            others{};
      double                                             others_weight = 0.;
      for (const unsigned int slot : slots)
        {
          others_weight += slopes[slot][weight];
          for (unsigned int d = 0; d < dim; ++d)
            others[d] += slopes[slot][weight] * slopes[slot][gradient + d];
        }
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        for (unsigned int d = 0; d < dim; ++d)
          if (slopes[slots[k]][weight] > 0.)
            gradients[k][d] = slopes[slots[k]][gradient + d];
          else if (others_weight > 0.)
            gradients[k][d] = others[d] / others_weight;

      smooth_pressure.resize(run.end - run.begin);
      for (unsigned int p = run.begin; p < run.end; ++p)
        {
          const Point<dim> x            = points.location(p);
          const auto       shape_values = cell.shape_values(x);
          double           sum          = 0.;
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            {
              const auto &node      = means[slots[k]];
              double      from_node = node[pressure];
              for (unsigned int d = 0; d < dim; ++d)
                from_node += gradients[k][d] * (x[d] - node[center + d]);
              sum += shape_values[k] * from_node;
            }
          smooth_pressure[p - run.begin] = std::max(sum, 0.);
        }
    });
  }

  template class PressureFilter<2>;
  template class PressureFilter<3>;
} // namespace mpm_granular::Transfer
