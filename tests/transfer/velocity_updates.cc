// How points take velocities from the grid and hand them on, against sums over
// the points written out here:
// - every scheme gives the points the momentum that the grid gained, and knows
//   the momentum that its points then give to the nodes (T16);
// - XPIC and FMPM are powers of the mapping to the grid and back, PIC for k = 1,
//   and for large k keep what the grid represents and drop what it does not
//   see;
// - APIC passes linear fields and angular momentum on unchanged.

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include "scattered_points.h"

#include <mpm_granular/transfer/velocity_update.h>

#include <iostream>
#include <memory>
#include <numeric>

using namespace Test;

template <int dim>
using Vectors = std::vector<Tensor<1, dim>>;

/// A skew-symmetric part as a vector: of a_i b_j, this is a x b.
template <int dim>
Tensor<1, dim == 2 ? 1 : 3>
axial(const Tensor<2, dim> &t)
{
  Tensor<1, dim == 2 ? 1 : 3> result;
  if constexpr (dim == 2)
    result[0] = t[0][1] - t[1][0];
  else
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = t[(d + 1) % 3][(d + 2) % 3] - t[(d + 2) % 3][(d + 1) % 3];
  return result;
}

template <int dim>
double
mass_of(const Points::PointArrays<dim> &points)
{
  return std::accumulate(points.mass.begin(), points.mass.end(), 0.);
}

template <int dim>
double
largest_difference(const Vectors<dim> &a, const Vectors<dim> &b)
{
  double largest = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

template <int dim>
struct Body
{
  std::unique_ptr<Transfer::VelocityUpdate<dim>> scheme;
  ScatteredPoints<dim>                           test;
  Points::PointArrays<dim>                      &points;
  Grid::NodalFields<dim>                        &fields;

  Body(const Mesh::MeshSource<dim> &source,
       const std::string           &name,
       const std::string           &entries = "")
    : scheme(Transfer::VelocityUpdateRegistry<dim>::make(name))
    , test(
        source,
        [](const Point<dim> &x) {
          Tensor<1, dim> v;
          for (unsigned int d = 0; d < dim; ++d)
            v[d] = std::sin(5. * x[d]) + x[(d + 1) % dim];
          return v;
        },
        MPI_COMM_SELF,
        scheme->history_names())
    , points(test.points.arrays())
    , fields(test.fields)
  {
    ParameterHandler prm;
    scheme->add_parameters(prm);
    prm.parse_input_from_string(entries);
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int slot = 0; slot < points.history.size(); ++slot)
        points.history[slot][p] = scattered(9 * p + slot) - .5;
  }

  /// Points to grid.
  /// @return v, by slot.
  Vectors<dim>
  map()
  {
    test.project();
    fields.clear_cells();
    test.for_each_block([&] {
      Transfer::find_shape_values(test.mesh, points, test.block);
      Transfer::relocate(test.mesh, test.partition, points, test.block);
      Transfer::add_mass_and_momentum(test.mesh, points, test.block, fields);
      scheme->give(test.mesh, points, test.block, fields);
    });
    fields.gather_nodes();
    Vectors<dim> velocity;
    for (const auto &node : fields.sums)
      velocity.push_back(node.momentum / node.mass);
    return velocity;
  }

  /// Grid to points, which stay where they are, with USL.
  /// @return what the re-mapped momentum is said to be, by slot.
  Vectors<dim>
  take(const Vectors<dim> &before, const Vectors<dim> &after)
  {
    constexpr double                     time_step = .01;
    const double                         c = scheme->pic_factor(time_step);
    const Grid::VelocityConstraints<dim> none;
    scheme->find_motion({before, after, none}, time_step, fields);
    Vectors<dim> momentum;
    for (const auto &node : fields.sums)
      momentum.push_back((1. - c) * node.momentum);
    scheme->add_momentum(fields, momentum);
    for (auto &node : fields.motion)
      node.straining = node.velocity; // USL
    test.for_each_block([&] {
      Transfer::evaluate_gradients(test.mesh, fields, points, test.block);
      scheme->take(test.block, points);
      Transfer::move_points(test.mesh, fields, test.block, 0., c, points);
    });
    return momentum;
  }

  Vectors<dim>
  velocities() const
  {
    Vectors<dim> result(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        result[p][d] = points.velocity[d][p];
    return result;
  }

  void
  set(const Vectors<dim> &velocities)
  {
    for (unsigned int p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        points.velocity[d][p] = velocities[p][d];
  }

  /// The affine part of a point, zero for most schemes.
  Tensor<2, dim>
  gradient(const unsigned int p) const
  {
    Tensor<2, dim> result;
    if (!points.history.empty())
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result[i][j] = points.history[i * dim + j][p];
    return result;
  }

  /// Calls action(slot, N, place of the node) for the nodes of a point's cell.
  template <class Action>
  void
  for_each_node(const unsigned int p, Action &&action) const
  {
    test.mesh.visit([&](const auto &cells) {
      const auto &cell   = cells[points.cell[p]];
      const auto  values = cell.shape_values(points.location(p));
      for (unsigned int k = 0; k < values.size(); ++k)
        action(fields.slot_of(cell.node[k]),
               values[k],
               test.mesh.node_position(cell.node[k]));
    });
  }

  /// S u.
  Vectors<dim>
  at_points(const Vectors<dim> &nodal) const
  {
    Vectors<dim> result(points.size());
    for (unsigned int p = 0; p < points.size(); ++p)
      for_each_node(p, [&](const auto slot, const auto N, const auto &) {
        result[p] += N * nodal[slot];
      });
    return result;
  }

  /// The momentum that points with velocities @p v give to the nodes.
  Vectors<dim>
  at_nodes(const Vectors<dim> &v) const
  {
    Vectors<dim> result(fields.n_active_nodes());
    for (unsigned int p = 0; p < points.size(); ++p)
      for_each_node(p, [&](const auto slot, const auto N, const auto &) {
        result[slot] += points.mass[p] * N * v[p];
      });
    return result;
  }

  /// Angular momentum of the points, with that of their affine parts.
  Tensor<1, dim == 2 ? 1 : 3>
  angular_momentum() const
  {
    Tensor<1, dim == 2 ? 1 : 3> sum;
    const auto                  v = velocities();
    for (unsigned int p = 0; p < points.size(); ++p)
      for_each_node(p, [&](const auto, const auto N, const auto &x) {
        const Tensor<1, dim> arm = x - points.location(p);
        sum += points.mass[p] * N *
               axial<dim>(
                 outer_product(Tensor<1, dim>(x), v[p] + gradient(p) * arm));
      });
    return sum;
  }

  /// The same of velocities of the nodes.
  Tensor<1, dim == 2 ? 1 : 3>
  angular_momentum(const Vectors<dim> &velocity) const
  {
    Tensor<1, dim == 2 ? 1 : 3> sum;
    for (unsigned int i = 0; i < velocity.size(); ++i)
      sum += fields.sums[i].mass *
             axial<dim>(outer_product(Tensor<1, dim>(test.mesh.node_position(
                                        fields.active_nodes[i])),
                                      velocity[i]));
    return sum;
  }
};

template <int dim>
Vectors<dim>
plus_change(const Vectors<dim> &velocity)
{
  auto result = velocity;
  for (unsigned int i = 0; i < result.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      result[i][d] += scattered(3 * i + d) - .3;
  return result;
}

/// Every scheme: momentum, and the momentum after the step at the nodes.
template <int dim>
void
test_momentum(const Mesh::MeshSource<dim> &source,
              const std::string           &name,
              const std::string           &entries = "")
{
  Body<dim>  body(source, name, entries);
  const auto before   = body.map();
  const auto after    = plus_change<dim>(before);
  const auto old      = body.velocities();
  const auto remapped = body.take(before, after);
  const auto taken    = body.velocities();

  double         scale = 0.;
  Tensor<1, dim> gained;
  for (unsigned int i = 0; i < before.size(); ++i)
    {
      gained -= body.fields.sums[i].mass * (after[i] - before[i]);
      scale += body.fields.sums[i].mass;
    }
  for (unsigned int p = 0; p < old.size(); ++p)
    gained += body.points.mass[p] * (taken[p] - old[p]);
  // APIC hands on the old field of its points, not their velocities alone.
  auto expected = body.at_nodes(taken);
  if (name == "APIC")
    {
      const double kept = entries.empty() ? 1. : .75;
      auto         rest = after;
      for (unsigned int i = 0; i < rest.size(); ++i)
        rest[i] -= kept * before[i];
      expected = body.at_nodes(body.at_points(rest));
      for (unsigned int i = 0; i < rest.size(); ++i)
        expected[i] += kept * body.fields.sums[i].momentum;
    }
  std::cout << "  " << name << ' ' << entries << ": momentum "
            << (gained.norm() < 1e-13 * scale) << ", at the nodes "
            << (largest_difference(remapped, expected) < 1e-11 * scale)
            << std::endl;
}

/// XPIC and FMPM against powers of the mapping, applied to the points.
template <int dim>
void
test_powers(const Mesh::MeshSource<dim> &source, const std::string &name)
{
  for (const unsigned int order : {1, 2, 5})
    {
      Body<dim>  body(source, name, "set Order = " + std::to_string(order));
      const auto before = body.map();
      const auto after  = plus_change<dim>(before);
      body.take(before, after);

      // XPIC filters the old velocities, FMPM the new ones.
      Vectors<dim> change(before.size()), filtered = before;
      for (unsigned int i = 0; i < before.size(); ++i)
        change[i] = after[i] - before[i];
      if (name == "FMPM")
        filtered = after;
      auto rest     = body.at_points(filtered);
      auto expected = rest;
      for (unsigned int power = 1; power < order; ++power)
        {
          auto mapped = body.at_nodes(rest);
          for (unsigned int i = 0; i < mapped.size(); ++i)
            mapped[i] /= body.fields.sums[i].mass;
          const auto back = body.at_points(mapped);
          for (unsigned int p = 0; p < rest.size(); ++p)
            expected[p] += rest[p] -= back[p];
        }
      if (name == "XPIC")
        {
          const auto added = body.at_points(change);
          for (unsigned int p = 0; p < added.size(); ++p)
            expected[p] += added[p];
        }
      Body<dim> pic(source, "PIC");
      pic.map();
      pic.take(before, after);
      std::cout << "  " << name << '(' << order << "): powers "
                << (largest_difference(body.velocities(), expected) < 1e-12)
                << ", is PIC "
                << (largest_difference(body.velocities(), pic.velocities()) ==
                    0.)
                << std::endl;
    }
}

/// Whether elimination finds a pivot of next to nothing.
bool
is_singular(FullMatrix<double> matrix)
{
  const double       least = 1e-6 * matrix.linfty_norm();
  const unsigned int n     = matrix.m();
  for (unsigned int c = 0; c < n; ++c)
    {
      unsigned int pivot = c;
      for (unsigned int r = c; r < n; ++r)
        if (std::abs(matrix(r, c)) > std::abs(matrix(pivot, c)))
          pivot = r;
      if (std::abs(matrix(pivot, c)) < least)
        return true;
      matrix.swap_row(c, pivot);
      for (unsigned int r = c + 1; r < n; ++r)
        matrix.add_row(r, -matrix(r, c) / matrix(c, c), c);
    }
  return false;
}

/// Velocities that the grid represents, and some that it does not see at all.
template <int dim>
void
test_null_space(const Mesh::MeshSource<dim> &source, const std::string &name)
{
  Vectors<dim> represented, unseen;
  for (const unsigned int order : {1, 4, 100})
    {
      Body<dim>  body(source, name, "set Order = " + std::to_string(order));
      const auto smooth = body.map();
      represented       = body.at_points(smooth);

      // Points of a cell, one more than it has nodes, whose momenta add up to
      // nothing at every node.
      unseen.assign(represented.size(), {});
      unsigned int n_sets = 0;
      const auto  &cells  = body.points.cell;
      body.test.mesh.visit([&](const auto &all) {
        using Cell = typename std::decay_t<decltype(all)>::value_type;
        constexpr unsigned int n = Cell::n_nodes;
        for (unsigned int p = 0; p + n < cells.size(); ++p)
          {
            if (cells[p + n] != cells[p])
              continue;
            const auto of = [&](const unsigned int q) {
              return all[cells[q]].shape_values(body.points.location(q));
            };
            FullMatrix<double> values(n, n);
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int k = 0; k < n; ++k)
                values(k, j) = body.points.mass[p + 1 + j] * of(p + 1 + j)[k];
            if (is_singular(values)) // points of a line
              continue;
            FullMatrix<double> inverse(values);
            inverse.gauss_jordan();
            const auto          first = of(p);
            std::vector<double> weight(n + 1);
            weight[0]      = -1.;
            double largest = 1.;
            for (unsigned int j = 0; j < n; ++j)
              {
                for (unsigned int k = 0; k < n; ++k)
                  weight[j + 1] +=
                    inverse(j, k) * body.points.mass[p] * first[k];
                largest = std::max(largest, std::abs(weight[j + 1]));
              }
            double rest = 0.;
            for (unsigned int k = 0; k < n; ++k)
              {
                double sum = -body.points.mass[p] * first[k];
                for (unsigned int j = 0; j < n; ++j)
                  sum += values(k, j) * weight[j + 1];
                rest += std::abs(sum);
              }
            if (!(rest < 1e-12 * largest))
              continue;
            ++n_sets;
            for (unsigned int j = 0; j <= n; ++j)
              unseen[p + j][0] = weight[j] / largest;
            p += n;
          }
      });
      auto velocities = represented;
      for (unsigned int p = 0; p < velocities.size(); ++p)
        velocities[p] += unseen[p];
      body.set(velocities);
      const auto mapped = body.map();
      body.take(mapped, mapped);

      double     kept = 0., lost = 0., mass = 0.;
      const auto taken = body.velocities();
      for (unsigned int p = 0; p < taken.size(); ++p)
        {
          kept += body.points.mass[p] * (taken[p] * unseen[p]);
          lost +=
            body.points.mass[p] * (taken[p] - represented[p]).norm_square();
          mass += body.points.mass[p];
        }
      std::cout << "  " << name << '(' << order << "): of the unseen, "
                << "which there is " << (n_sets > 20) << ", nothing is kept "
                << (std::abs(kept) < 1e-12 * mass) << ", of the represented ";
      const double error = std::sqrt(lost / mass);
      std::cout << (error < 1e-3 ? "less than 0.001" :
                    error < 1e-1 ? "less than 0.1" :
                                   "more than 0.1")
                << " is lost" << std::endl;
    }
}

/// APIC: linear fields and angular momentum.
template <int dim>
void
test_affine(const Mesh::MeshSource<dim> &source, const std::string &name)
{
  Body<dim>    body(source, name);
  const auto   at_start = body.angular_momentum();
  const auto   mapped   = body.map();
  const auto   on_grid  = body.angular_momentum(mapped);
  const auto   after    = plus_change<dim>(mapped);
  const double scale    = mass_of(body.points);
  body.take(mapped, after);
  const auto new_on_grid = body.angular_momentum(after);

  std::cout << "  " << name << ": angular momentum, to the grid "
            << ((on_grid - at_start).norm() < 1e-12 * scale)
            << ", to the points "
            << ((body.angular_momentum() - new_on_grid).norm() < 1e-12 * scale);

  // A rotation and a strain.
  Tensor<2, dim> L;
  Tensor<1, dim> constant;
  for (unsigned int i = 0; i < dim; ++i)
    {
      constant[i] = 1. + i;
      for (unsigned int j = 0; j < dim; ++j)
        L[i][j] = scattered(3 * i + j) - .5;
    }
  Vectors<dim> linear;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    {
      linear.push_back(constant + L * body.points.location(p));
      body.scheme->initialize(body.points, p, L);
    }
  body.set(linear);
  const auto   nodal = body.map();
  Vectors<dim> exact;
  for (unsigned int i = 0; i < nodal.size(); ++i)
    exact.push_back(
      constant + L * body.test.mesh.node_position(body.fields.active_nodes[i]));
  body.take(nodal, nodal);
  double worst_gradient = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    worst_gradient = std::max(worst_gradient, (body.gradient(p) - L).norm());
  std::cout << "; linear field, on the grid "
            << (largest_difference(nodal, exact) < 1e-11) << ", on points "
            << (largest_difference(body.velocities(), linear) < 1e-11)
            << ", its gradient " << (worst_gradient < 1e-11) << std::endl;
}

template <int dim>
void
test(const Mesh::MeshSource<dim> &source, const std::string &cells)
{
  std::cout << dim << "D, " << cells << std::endl;
  for (const auto *name : {"FLIP", "PIC", "blend", "XPIC", "FMPM", "APIC"})
    test_momentum(source, name);
  test_momentum(source, "blend", "set Order = 3");
  test_momentum(source, "APIC", "set Gradient damping rate = 25");
  for (const auto *name : {"XPIC", "FMPM"})
    {
      test_powers(source, name);
      test_null_space(source, name);
    }
  for (const auto *name : {"APIC", "PIC"})
    test_affine(source, name);
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4), "simplices");
  test<3>(JitteredBox<3>(4), "simplices");
  test<2>(BoxMesh<2>("hypercubes", 8), "hypercubes");
  test<3>(BoxMesh<3>("hypercubes", 6), "hypercubes");
}
