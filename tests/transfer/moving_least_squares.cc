// Shape functions by moving least squares: they add up to one, reproduce linear
// fields, are not negative, and with their gradients are continuous across
// faces; those of inner nodes vanish on the surface of the mesh. Points give
// all of their mass and momentum to the nodes and no net force or moment;
// forces do the work of the stresses; and all ranks together find what one
// does.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/mls_functions.h>

#include <iostream>
#include <map>

using namespace Test;

template <int dim>
using NodeFunctions = std::vector<Grid::NodeFunction<dim>>;

/// Of a place in a cell, from its shape values there.
template <int dim>
Point<dim>
place(const Mesh::BackgroundMesh<dim>   &mesh,
      const unsigned int                 cell,
      const std::array<double, dim + 1> &shape_values)
{
  Point<dim> x;
  for (unsigned int k = 0; k <= dim; ++k)
    x += shape_values[k] * mesh.node_position(mesh.nodes(cell)[k]);
  return x;
}

/// The functions at a place by node; zero elsewhere.
template <int dim>
std::map<unsigned int, Tensor<1, dim + 1>>
by_node(Transfer::MlsFunctions<dim> &mls,
        const unsigned int           cell,
        const Point<dim>            &x)
{
  NodeFunctions<dim> functions;
  mls.evaluate(cell, x, functions);
  std::map<unsigned int, Tensor<1, dim + 1>> result;
  for (const auto &function : functions)
    {
      result[function.node][dim] = function.value;
      for (unsigned int d = 0; d < dim; ++d)
        result[function.node][d] = function.gradient[d];
    }
  return result;
}

template <int dim>
void
test_functions()
{
  const Mesh::BackgroundMesh<dim> mesh(JitteredBox<dim>(4), "", MPI_COMM_SELF);
  Transfer::MlsFunctions<dim>     mls;
  mls.reinit(mesh);
  const auto is_inner = [&](const Point<dim> &x) {
    bool is = true;
    for (unsigned int d = 0; d < dim; ++d)
      is &= x[d] > .001 && x[d] < .999;
    return is;
  };

  double       unity = 0., linear = 0., gradients = 0., least = 1.;
  double       jump = 0., on_surface = 0., largest = 0.;
  unsigned int n_nodes = 0, n_beyond = 0, n_faces = 0;
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    {
      std::array<double, dim + 1> inside;
      double                      sum = 0.;
      for (unsigned int k = 0; k <= dim; ++k)
        sum += inside[k] = .05 + scattered(7 * cell + k);
      for (double &value : inside)
        value /= sum;
      const Point<dim>   x = place(mesh, cell, inside);
      NodeFunctions<dim> functions;
      mls.evaluate(cell, x, functions);
      double         total = -1.;
      Tensor<1, dim> center;
      Tensor<2, dim> identity;
      for (const auto &function : functions)
        {
          const Tensor<1, dim> arm = mesh.node_position(function.node) - x;
          total += function.value;
          center += function.value * arm;
          identity += outer_product(arm, function.gradient);
          least   = std::min(least, function.value);
          largest = std::max(largest, function.gradient.norm());
        }
      n_nodes += functions.size();
      n_beyond += functions.size() > dim + 1;
      unity     = std::max(unity, std::abs(total));
      linear    = std::max(linear, center.norm());
      gradients = std::max(
        gradients,
        (identity - Tensor<2, dim>(unit_symmetric_tensor<dim>())).norm());

      // Just this side of each face, and just beyond it.
      constexpr double step = 1e-9;
      for (unsigned int f = 0; f <= dim; ++f)
        {
          auto on_face = inside;
          on_face[f]   = step;
          for (unsigned int k = 0; k <= dim; ++k)
            if (k != f)
              on_face[k] /= (1. - inside[f]) / (1. - step);
          const auto         here     = place(mesh, cell, on_face);
          const unsigned int neighbor = mesh.neighbors(cell)[f];
          const auto         values   = by_node(mls, cell, here);
          if (neighbor == Mesh::no_cell)
            for (const auto &[node, value] : values)
              {
                const auto at = mesh.node_position(node);
                if (is_inner(at))
                  on_surface = std::max(on_surface, value[dim]);
              }
          else
            {
              on_face[f]           = -step;
              const auto   there   = place(mesh, cell, on_face);
              auto         beyond  = by_node(mls, neighbor, there);
              unsigned int n_inner = 0;
              for (const unsigned int node : mesh.nodes(cell))
                n_inner += is_inner(mesh.node_position(node));
              ++n_faces;
              // Where values are kept from being negative, next to the surface,
              // gradients may jump.
              for (const auto &[node, value] : values)
                beyond[node] -= value;
              for (const auto &[node, difference] : beyond)
                for (unsigned int d = 0; d <= dim; ++d)
                  if (d == dim || n_inner == dim + 1)
                    jump = std::max(jump, std::abs(difference[d]));
            }
        }
    }
  std::cout << dim << "D: sum of one " << (unity < 1e-12)
            << ", linear fields exact " << (linear < 1e-9)
            << ", and their gradients " << (gradients < 1e-11) << ", positive "
            << (least > 0.) << ", reach beyond cells "
            << (n_beyond > mesh.n_cells() / 2) << ", to "
            << std::round(double(n_nodes) / mesh.n_cells()) << " nodes"
            << std::endl
            << "continuous across faces "
            << (n_faces > mesh.n_cells() && jump < 1e-6 * largest)
            << ", inner nodes vanish on the surface " << (on_surface < 1e-7)
            << std::endl;
}

/// The sums of all nodes, by global node: masses, momenta, forces and the
/// action of the mass matrix on some field.
template <int dim>
using Sums = std::map<unsigned int, std::array<double, 1 + 3 * dim>>;

template <int dim>
Tensor<1, dim>
wavy(const Point<dim> &x)
{
  Tensor<1, dim> v;
  for (unsigned int d = 0; d < dim; ++d)
    v[d] = std::sin(3. * x[(d + 1) % dim] + d) * x[d];
  return v;
}

template <int dim>
struct Body
{
  std::unique_ptr<Transfer::Averaging<dim>> averaging =
    Transfer::AveragingRegistry<dim>::make("moving least squares");
  Mesh::BackgroundMesh<dim>   mesh;
  Mesh::Partition<dim>        partition;
  Points::MaterialPoints<dim> points;
  Grid::NodalFields<dim>      fields;
  Transfer::PointBlock<dim>   block;

  explicit Body(const MPI_Comm communicator)
    : mesh(JitteredBox<dim>(5), "", communicator)
    , partition({}, mesh, communicator, averaging->reaches_beyond_cells())
    , points(mesh, partition, {})
    , fields(mesh, partition)
  {
    std::vector<Point<dim>> places(400);
    for (unsigned int i = 0; i < places.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        places[i][d] = .1 + .5 * scattered(dim * i + d);
    points.insert(seeds_at(mesh, places, 1e-3), 0, 1000.);
    points.load();
    auto &arrays = points.arrays();
    for (unsigned int p = 0; p < arrays.size(); ++p)
      {
        arrays.mass[p] *= 1. + scattered(arrays.id[p]);
        const auto v = wavy(arrays.location(p));
        for (unsigned int d = 0; d < dim; ++d)
          arrays.velocity[d][p] = v[d] + 1.;
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          arrays.stress[s][p] = scattered(9 * arrays.id[p] + s) - .3;
      }
    averaging->reinit(mesh, partition, {});
  }

  template <class Action>
  void
  for_each_block(Action &&action)
  {
    auto &arrays = points.arrays();
    for (unsigned int next = 0; next < arrays.size(); next = block.end)
      {
        block.reinit(arrays, next);
        action();
      }
  }

  /// Lets points enter ghost cells without moving to another rank.
  void
  push(const double distance)
  {
    for (double &x : points.arrays().position[0])
      x += distance;
  }

  /// @return whether all points are within reach of this rank.
  bool
  project()
  {
    bool  is_within_reach = true;
    auto &arrays          = points.arrays();
    fields.clear_cells();
    averaging->clear();
    for_each_block([&] {
      Transfer::find_shape_values(mesh, arrays, block);
      const auto relocation =
        Transfer::relocate(mesh, partition, arrays, block);
      is_within_reach &= !relocation.is_out_of_reach;
      averaging->add_mass_and_momentum(mesh, arrays, block, fields);
      averaging->add_stresses(arrays, block, fields);
    });
    fields.gather_nodes();
    fields.gather_forces(); // the same once more
    return is_within_reach;
  }

  Sums<dim>
  sums()
  {
    std::vector<Tensor<1, dim>> field, product(fields.n_active_nodes());
    for (const unsigned int node : fields.active_nodes)
      field.push_back(wavy(mesh.node_position(node)));
    fields.add_mass_times(field, product);
    Sums<dim> result;
    for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
      {
        auto &of_node = result[mesh.global_node(fields.active_nodes[i])];
        of_node[0]    = fields.sums[i].mass;
        for (unsigned int d = 0; d < dim; ++d)
          {
            of_node[1 + d]           = fields.sums[i].momentum[d];
            of_node[1 + dim + d]     = fields.sums[i].force[d];
            of_node[1 + 2 * dim + d] = product[i][d];
          }
      }
    return result;
  }
};

template <int dim>
void
test_conservation()
{
  Body<dim> body(MPI_COMM_SELF);
  body.project();
  const auto    &arrays = body.points.arrays();
  double         mass = 0., lost_mass = 0., torque = 0., power = 0.;
  double         largest = 0., least = 1.;
  Tensor<1, dim> momentum, lost_momentum, force;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      mass += arrays.mass[p];
      for (unsigned int d = 0; d < dim; ++d)
        momentum[d] += arrays.mass[p] * arrays.velocity[d][p];
    }
  lost_mass     = mass;
  lost_momentum = momentum;
  body.fields.extend_motion();
  for (unsigned int i = 0; i < body.fields.n_active_nodes(); ++i)
    {
      const auto &node = body.fields.sums[i];
      const auto  x    = body.mesh.node_position(body.fields.active_nodes[i]);
      const auto  v    = wavy(x);
      lost_mass -= node.mass;
      lost_momentum -= node.momentum;
      force += node.force;
      torque += x[0] * node.force[1] - x[1] * node.force[0];
      power += node.force * v;
      largest                         = std::max(largest, node.force.norm());
      least                           = std::min(least, node.mass);
      body.fields.motion[i].straining = v;
    }
  double       stress_power = 0.;
  unsigned int n_strained   = 0;
  body.for_each_block([&] {
    body.averaging->evaluate(body.fields, arrays, body.block);
    for (unsigned int r = 0; r < body.block.strained.size(); ++r)
      for (unsigned int p = body.block.strained[r].begin;
           p < body.block.strained[r].end;
           ++p, ++n_strained)
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          {
            const auto        &L = body.block.gradients[r];
            const unsigned int i = stress_index[s][0], j = stress_index[s][1];
            if (i < dim && j < dim)
              stress_power += arrays.volume[p] * arrays.stress[s][p] *
                              (i == j ? L[i][i] : L[i][j] + L[j][i]);
          }
  });
  std::cout << "mass exact " << (std::abs(lost_mass) < 1e-13 * mass)
            << ", momentum exact "
            << (lost_momentum.norm() < 1e-13 * momentum.norm())
            << ", masses positive " << (least > 0.) << ", no net force "
            << (force.norm() < 1e-12 * largest) << ", no net moment "
            << (std::abs(torque) < 1e-12 * largest)
            << ", forces do the work of stresses "
            << (n_strained == arrays.size() &&
                std::abs(power + stress_power) < 1e-12 * std::abs(power))
            << std::endl;
}

template <int dim>
void
test_ranks()
{
  Body<dim> alone(MPI_COMM_SELF), shared(MPI_COMM_WORLD);
  double    worst = 0., scale[] = {0., 0., 0., 0.};
  bool      is_within_reach = true;
  for (const double distance : {0., .1})
    {
      alone.push(distance);
      shared.push(distance);
      alone.project();
      is_within_reach &= shared.project();
      const auto expected = alone.sums();
      for (const auto &[node, values] : expected)
        for (unsigned int i = 0; i < values.size(); ++i)
          scale[(i + dim - 1) / dim] =
            std::max(scale[(i + dim - 1) / dim], std::abs(values[i]));
      // Every node that is active here has its sums over all ranks, if it is a
      // node of this rank's cells.
      for (const auto &[node, values] : shared.sums())
        for (unsigned int i = 0; i < values.size(); ++i)
          worst = std::max(worst,
                           std::abs(values[i] - expected.at(node)[i]) /
                             scale[(i + dim - 1) / dim]);
      unsigned int n_counted = 0;
      for (unsigned int i = 0; i < shared.fields.n_active_nodes(); ++i)
        n_counted += shared.fields.shared.counts(i);
      n_counted = Utilities::MPI::sum(n_counted, MPI_COMM_WORLD);
      if (n_counted != expected.size())
        worst = 1e10;
    }
  worst = Utilities::MPI::max(worst, MPI_COMM_WORLD);
  is_within_reach =
    Utilities::MPI::min(int(is_within_reach), MPI_COMM_WORLD) == 1;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << dim << "D: points in reach of their ranks " << is_within_reach
              << ", sums of one rank on all " << (worst < 1e-12) << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      test_functions<2>();
      test_conservation<2>();
      test_functions<3>();
      test_conservation<3>();
    }
  test_ranks<2>();
  test_ranks<3>();
}
