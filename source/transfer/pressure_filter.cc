#include <mpm_granular/transfer/point_groups.h>
#include <mpm_granular/transfer/pressure_filter.h>

#include <algorithm>
#include <tuple>

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
                           const PointBlock<dim>          &block,
                           const Points::Run               run)
  {
    const auto place        = pointers(points.position);
    const auto shape_values = pointers(block.shape_values);
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      constexpr unsigned int n_nodes = Cell::n_nodes;

      // Lanes of nodes; where a cell has fewer, the last have no meaning.
      constexpr unsigned int n_lanes = (n_nodes + Lanes::n - 1) / Lanes::n;
      Lanes                  sums[n_means][n_lanes] = {};
      double                 in_contact             = 0.;
      for (unsigned int p = run.begin; p < run.end; ++p)
        {
          const double point_pressure = points.pressure(p);
          const double point_volume =
            point_pressure > 0. ? points.volume[p] : 0.;
          in_contact += point_volume;
          for (unsigned int l = 0; l < n_lanes; ++l)
            {
              const auto shape_value = [&](const unsigned int k) {
                return shape_values[Lanes::n * l + k][p - block.begin];
              };
              const Lanes share = Lanes(shape_value(0),
                                        shape_value(1),
                                        shape_value(2),
                                        shape_value(3)) *
                                  point_volume;
              sums[volume][l] += share;
              sums[pressure][l] += share * point_pressure;
              for (unsigned int d = 0; d < dim; ++d)
                sums[center + d][l] += share * place[d][p];
            }
        }

      const unsigned int slot  = fields.slot_of_cell(points.cell[run.begin]);
      const auto        &slots = fields.template cells<Cell>().nodes[slot];
      cell_volume[slot] += in_contact;
      for (unsigned int k = 0; k < n_nodes; ++k)
        {
          std::array<double, n_means> part;
          for (unsigned int m = 0; m < n_means; ++m)
            part[m] = sums[m][k / Lanes::n].data[k % Lanes::n];
          fields.hanging.add_at(means, slots[k], part);
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
  template <class Slots>
  auto
  PressureFilter<dim>::gradients_at(const Slots &slots) const
  {
    // Where all cells around a node are too poor in points for a gradient, that
    // of the other nodes of the cell stands in.
    std::array<Tensor<1, dim>, std::tuple_size<Slots>::value> result;
    Tensor<1, dim>                                            others;
    double                                                    total   = 0.;
    unsigned int                                              n_known = 0;
    for (unsigned int k = 0; k < slots.size(); ++k)
      {
        const auto &slope = slopes[slots[k]];
        n_known += slope[weight] > 0.;
        total += slope[weight];
        for (unsigned int d = 0; d < dim; ++d)
          {
            result[k][d] = slope[gradient + d];
            others[d] += slope[weight] * slope[gradient + d];
          }
      }
    if (n_known > 0)
      for (unsigned int k = 0; k < slots.size() && n_known < slots.size(); ++k)
        if (!(slopes[slots[k]][weight] > 0.))
          result[k] = others / total;
    return result;
  }



  template <int dim>
  void
  PressureFilter<dim>::evaluate(
    const Grid::NodalFields<dim>    &fields,
    const Points::PointArrays<dim>  &points,
    const PointBlock<dim>           &block,
    typename PointBlock<dim>::Array &smooth_pressure) const
  {
    const unsigned int n_points     = points.size();
    const auto         place        = pointers(points.position);
    const auto         shape_values = pointers(block.shape_values);
    mesh.visit([&](const auto &cells) {
      using Cell         = typename std::decay_t<decltype(cells)>::value_type;
      const auto &active = fields.template cells<Cell>();
      for (const auto &run : block.runs)
        {
          const auto &slots =
            active.nodes[fields.slot_of_cell(points.cell[run.begin])];
          const auto gradients = gradients_at(slots);
          double     at_origin[Cell::n_nodes];
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            {
              const auto &node = means[slots[k]];
              at_origin[k]     = node[pressure];
              for (unsigned int d = 0; d < dim; ++d)
                at_origin[k] -= gradients[k][d] * node[center + d];
            }
          for_each_group(run, n_points, [&](const auto type, const auto p) {
            using Number        = std::decay_t<decltype(type)>;
            const std::size_t i = p - block.begin;
            const auto        x = load_all<Number>(place, p);
            Number            sum(0.);
            for (unsigned int k = 0; k < Cell::n_nodes; ++k)
              {
                Number from_node(at_origin[k]);
                for (unsigned int d = 0; d < dim; ++d)
                  from_node += gradients[k][d] * x[d];
                sum += load<Number>(shape_values[k] + i) * from_node;
              }
            store(sum, smooth_pressure.data() + i);
          });
        }
    });
    for (double &value : smooth_pressure)
      value = std::max(value, 0.);
  }

  template class PressureFilter<2>;
  template class PressureFilter<3>;
} // namespace mpm_granular::Transfer
