#include <mpm_granular/grid/spread_sums.h>

namespace mpm_granular::Grid
{
  using namespace dealii;

  template <int dim>
  void
  SpreadSums<dim>::reinit(const unsigned int n_nodes_of_mesh)
  {
    place_of_node.assign(n_nodes_of_mesh, 0);
    clear();
  }

  template <int dim>
  void
  SpreadSums<dim>::clear()
  {
    nodes.clear();
    sums.clear();
    masses.clear();
    n_values.clear();
    node_of_value.clear();
    values.clear();
  }

  template <int dim>
  void
  SpreadSums<dim>::clear_forces()
  {
    for (auto &node : sums)
      node.force = 0.;
  }

  template <int dim>
  void
  SpreadSums<dim>::add(const double          mass,
                       const Tensor<1, dim> &velocity,
                       const Functions      &functions)
  {
    masses.push_back(mass);
    n_values.push_back(functions.size());
    for (const auto &function : functions)
      {
        node_of_value.push_back(function.node);
        values.push_back(function.value);
        if (!is_known(function.node))
          {
            place_of_node[function.node] = nodes.size();
            nodes.push_back(function.node);
            sums.emplace_back();
          }
        auto        &node = sums[place_of_node[function.node]];
        const double part = mass * function.value;
        node.mass += part;
        node.momentum += part * velocity;
      }
  }

  template <int dim>
  void
  SpreadSums<dim>::serialize(Core::Archive &archive)
  {
    constexpr unsigned int n_numbers = 1 + 2 * dim;
    std::vector<double>    numbers;
    for (const auto &node : sums)
      {
        numbers.push_back(node.mass);
        for (unsigned int d = 0; d < dim; ++d)
          numbers.push_back(node.momentum[d]);
        for (unsigned int d = 0; d < dim; ++d)
          numbers.push_back(node.force[d]);
      }
    archive.distributed("spread/nodes", nodes);
    archive.distributed("spread/node_sums", numbers, n_numbers);
    archive.distributed("spread_points/masses", masses);
    archive.distributed("spread_points/n_values", n_values);
    archive.distributed("spread_values/nodes", node_of_value);
    archive.distributed("spread_values/values", values);
    if (!archive.is_reading())
      return;
    sums.assign(nodes.size(), {});
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        place_of_node[nodes[i]] = i;
        const double *number    = numbers.data() + i * n_numbers;
        sums[i].mass            = *number++;
        for (unsigned int d = 0; d < dim; ++d, ++number)
          {
            sums[i].momentum[d] = number[0];
            sums[i].force[d]    = number[dim];
          }
      }
  }

  template <int dim>
  std::size_t
  SpreadSums<dim>::memory_consumption() const
  {
    return (place_of_node.capacity() + nodes.capacity() + n_values.capacity() +
            node_of_value.capacity()) *
             sizeof(unsigned int) +
           sums.capacity() * sizeof(NodeSums<dim>) +
           (masses.capacity() + values.capacity()) * sizeof(double);
  }

  template class SpreadSums<2>;
  template class SpreadSums<3>;
} // namespace mpm_granular::Grid
