#include <deal.II/base/symmetric_tensor.h>

#include <mpm_granular/transfer/mls_functions.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// Radius of the kernel in sizes of the cells around the node (T90).
    constexpr double relative_radius = 1.5;

    /// Weights below this part of the largest possible one do not count.
    constexpr double least_weight = 1e-12;

    /// The part of the linear functions that is always mixed in: no node of an
    /// active cell is without mass.
    constexpr double linear_part = 1e-10;

    /// The same as in relocate(): so far inside its cell a point is seen.
    constexpr double least_shape_value = 1e-10;

    /// A fit is determined if the volume that the nodes span is not this small
    /// against that of a ball.
    constexpr double flattest = 1e-8;
  } // namespace

  template <int dim>
  void
  MlsFunctions<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh)
  {
    mesh               = &new_mesh;
    cell_of_candidates = Mesh::no_cell;
    place_of_node.assign(mesh->n_nodes(), 0);
    std::vector<std::vector<unsigned int>> around(mesh->n_nodes());
    std::vector<unsigned int>              n_cells_of_node(mesh->n_nodes());
    for (unsigned int cell = 0; cell < mesh->n_cells(); ++cell)
      for (const unsigned int node : mesh->nodes(cell))
        {
          ++n_cells_of_node[node];
          for (const unsigned int other : mesh->nodes(cell))
            if (other != node)
              around[node].push_back(other);
        }
    first_neighbor.assign(1, 0);
    neighbors.clear();
    radii.clear();
    for (unsigned int node = 0; node < mesh->n_nodes(); ++node)
      {
        auto &list = around[node];
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        neighbors.insert(neighbors.end(), list.begin(), list.end());
        first_neighbor.push_back(neighbors.size());
        const double mean_volume =
          mesh->node_volume(node) * Cell::n_nodes / n_cells_of_node[node];
        radii.push_back(
          relative_radius *
          std::pow(mean_volume / Cell::reference_volume, 1. / dim));
      }
  }

  template <int dim>
  void
  MlsFunctions<dim>::add_candidate(const unsigned int node)
  {
    place_of_node[node] = candidates.size();
    candidates.push_back(
      {node, mesh->node_position(node), 1. / (radii[node] * radii[node]), {}});
  }

  template <int dim>
  void
  MlsFunctions<dim>::find_candidates(const unsigned int cell)
  {
    cell_of_candidates = cell;
    candidates.clear();
    const auto &own = mesh->template cells<Cell>()[cell].node;
    for (const unsigned int node : own)
      add_candidate(node);
    for (unsigned int k = 0; k < own.size(); ++k)
      {
        candidates[k].is_next_to[k] = 1.;
        for (unsigned int i = first_neighbor[own[k]];
             i < first_neighbor[own[k] + 1];
             ++i)
          {
            const unsigned int node  = neighbors[i];
            const unsigned int place = place_of_node[node];
            if (!(place < candidates.size() && candidates[place].node == node))
              add_candidate(node);
            candidates[place_of_node[node]].is_next_to[k] = 1.;
          }
      }
  }

  template <int dim>
  void
  MlsFunctions<dim>::find_samples(
    const Point<dim>                               &x,
    const std::array<double, std::size_t(dim + 1)> &shape_values)
  {
    samples.clear();
    for (unsigned int c = 0; c < candidates.size(); ++c)
      {
        const auto          &candidate = candidates[c];
        const Tensor<1, dim> offset    = candidate.position - x;
        const double         inside =
          1. - offset.norm_square() * candidate.inverse_square;
        double factor = 0.;
        for (unsigned int k = 0; k < Cell::n_nodes; ++k)
          factor += candidate.is_next_to[k] * shape_values[k];
        const double weight = factor * inside * inside; // (T90)
        if (inside > 0. && weight > least_weight)
          samples.push_back({c, weight, offset, 0., {}});
      }
  }

  template <int dim>
  void
  MlsFunctions<dim>::evaluate(const unsigned int                    cell,
                              const Point<dim>                     &x,
                              std::vector<Grid::NodeFunction<dim>> &functions)
  {
    if (cell != cell_of_candidates)
      find_candidates(cell);
    const Cell &simplex = mesh->template cells<Cell>()[cell];
    const auto  linear  = simplex.inner_shape_values(x, least_shape_value);
    find_samples(x, linear);

    const bool        is_fitted = fit();
    const std::size_t first     = functions.size();
    for (unsigned int k = 0; k < Cell::n_nodes; ++k)
      if (is_fitted)
        functions.push_back({simplex.node[k], linear_part * linear[k], {}});
      else
        functions.push_back(
          {simplex.node[k], linear[k], simplex.shape_gradient(k)});
    if (!is_fitted)
      return;
    for (const auto &sample : samples)
      {
        const unsigned int c     = sample.candidate;
        const double       value = (1. - linear_part) * sample.value;
        if (c >= Cell::n_nodes)
          functions.push_back({candidates[c].node, value, sample.gradient});
        else
          {
            functions[first + c].value += value;
            functions[first + c].gradient = sample.gradient;
          }
      }
  }

  template <int dim>
  bool
  MlsFunctions<dim>::fit()
  {
    while (true)
      {
        // About the centre of the weights the moments of zeroth and of second
        // order do not mix (T91).
        double         total = 0.;
        Tensor<1, dim> center;
        for (const auto &sample : samples)
          {
            total += sample.weight;
            center += sample.weight * sample.offset;
          }
        center /= total;
        SymmetricTensor<2, dim> moments;
        for (const auto &sample : samples)
          {
            const Tensor<1, dim> arm = sample.offset - center;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = i; j < dim; ++j)
                moments[i][j] += sample.weight * arm[i] * arm[j];
          }
        double of_ball = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          of_ball *= trace(moments) / dim;
        if (!(determinant(moments) > flattest * of_ball))
          return false;

        const SymmetricTensor<2, dim> inverse = invert(moments);
        for (auto &sample : samples)
          {
            sample.gradient =
              sample.weight * (inverse * (sample.offset - center));
            sample.value = sample.weight / total - sample.gradient * center;
          }
        const auto negative =
          std::remove_if(samples.begin(),
                         samples.end(),
                         [](const auto &sample) { return sample.value <= 0.; });
        if (negative == samples.end())
          return true;
        samples.erase(negative, samples.end());
      }
  }

  template class MlsFunctions<2>;
  template class MlsFunctions<3>;
} // namespace mpm_granular::Transfer
