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
    nodes.assign(fields.n_active_nodes(), {});
    cell_volume.assign(fields.active_cells.size(), 0.);
  }



  template <int dim>
  void
  PressureFilter<dim>::add(const Grid::NodalFields<dim>   &fields,
                           const Points::PointArrays<dim> &points,
                           const Points::Run               run)
  {
    const unsigned int cell  = points.cell[run.begin];
    const unsigned int slot  = fields.slot_of_cell(cell);
    const auto        &slots = fields.cell_nodes[slot];
    for (unsigned int p = run.begin; p < run.end; ++p)
      {
        const double pressure = points.pressure(p);
        if (pressure <= 0.)
          continue;
        const double     volume       = points.volume[p];
        const Point<dim> x            = points.location(p);
        const auto       shape_values = mesh.cell(cell).shape_values(x);
        cell_volume[slot] += volume;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            Node        &node   = nodes[slots[k]];
            const double weight = shape_values[k] * volume;
            node.volume += weight;
            node.pressure += weight * pressure;
            node.center += weight * Tensor<1, dim>(x);
          }
      }
  }



  template <int dim>
  void
  PressureFilter<dim>::find_gradients(const Grid::NodalFields<dim> &fields)
  {
    for (Node &node : nodes)
      if (node.volume > 0.)
        {
          node.pressure /= node.volume;
          node.center /= node.volume;
        }

    // The simplex of the centers of its nodes, where it is not too flat a
    // picture of the cell, has a gradient of the mean pressures.
    constexpr double flattest = dim == 2 ? 0.2 : 0.1;
    for (unsigned int c = 0; c < cell_volume.size(); ++c)
      {
        const auto &slots      = fields.cell_nodes[c];
        const auto  is_sampled = [&](const unsigned int slot) {
          return nodes[slot].volume > 0.;
        };
        if (cell_volume[c] == 0. ||
            !std::all_of(slots.begin(), slots.end(), is_sampled))
          continue;
        Tensor<2, dim> map; // from the cell to the centers of its nodes
        Tensor<1, dim> slope;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            const Tensor<1, dim> gradient =
              mesh.cell(fields.active_cells[c]).shape_gradient(k);
            map +=
              outer_product(Tensor<1, dim>(nodes[slots[k]].center), gradient);
            slope += nodes[slots[k]].pressure * gradient;
          }
        if (determinant(map) <= flattest)
          continue;
        const Tensor<1, dim> gradient = transpose(invert(map)) * slope;
        for (const unsigned int slot : slots)
          {
            nodes[slot].gradient += cell_volume[c] * gradient;
            nodes[slot].gradient_volume += cell_volume[c];
          }
      }
    for (Node &node : nodes)
      if (node.gradient_volume > 0.)
        node.gradient /= node.gradient_volume;
  }



  template <int dim>
  void
  PressureFilter<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                                const Points::PointArrays<dim> &points,
                                const Points::Run               run,
                                std::vector<double>            &pressure) const
  {
    const unsigned int cell  = points.cell[run.begin];
    const auto        &slots = fields.cell_nodes[fields.slot_of_cell(cell)];
    pressure.resize(run.end - run.begin);
    for (unsigned int p = run.begin; p < run.end; ++p)
      {
        const Point<dim> x            = points.location(p);
        const auto       shape_values = mesh.cell(cell).shape_values(x);
        double           sum          = 0.;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            const Node &node = nodes[slots[k]];
            sum += shape_values[k] *
                   (node.pressure + node.gradient * (x - node.center));
          }
        pressure[p - run.begin] = std::max(sum, 0.);
      }
  }

  template class PressureFilter<2>;
  template class PressureFilter<3>;
} // namespace mpm_granular::Transfer
