// The masses, momenta and forces of nodes, and the action of the mass matrix,
// are on any number of ranks what they are on one; nodes that several ranks
// know are the same to the last bit there and count once.

#include <deal.II/base/mpi.h>

#include "../transfer/scattered_points.h"

#include <array>
#include <iostream>
#include <map>

using namespace Test;

template <int dim>
void
test(const Mesh::MeshSource<dim> &source, const bool is_refined = false)
{
  const auto velocity = [](const Point<dim> &x) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = std::sin(5. * x[d]) + x[(d + 1) % dim];
    return v;
  };
  ScatteredPoints<dim> alone(source, velocity, MPI_COMM_SELF);
  ScatteredPoints<dim> together(source, velocity, MPI_COMM_WORLD);
  if (is_refined)
    for (auto *mesh : {&alone, &together})
      {
        Point<dim> center;
        for (unsigned int d = 0; d < dim; ++d)
          center[d] = .4 + .1 * d;
        mesh->refine_near(center);
      }
  alone.project();
  together.project();

  // Ranks number nodes as they like: a node is known by its place.
  using Key         = std::array<long, dim>;
  const auto key_of = [](const Point<dim> &x) {
    Key key;
    for (unsigned int d = 0; d < dim; ++d)
      key[d] = std::lround(x[d] * 1e9);
    return key;
  };
  std::map<Key, unsigned int> node_at;
  for (unsigned int node = 0; node < alone.mesh.n_nodes(); ++node)
    node_at[key_of(alone.mesh.node_position(node))] = node;
  const auto node_alone = [&](const unsigned int node) {
    return node_at.at(key_of(together.mesh.node_position(node)));
  };

  const auto product = [](ScatteredPoints<dim> &test) {
    const unsigned int          n = test.fields.n_active_nodes();
    std::vector<Tensor<1, dim>> field(n), result(n);
    for (unsigned int i = 0; i < n; ++i)
      field[i][0] =
        std::cos(9. * test.mesh.node_position(test.fields.active_nodes[i])[1]);
    test.fields.add_mass_times(field, result);
    return result;
  };
  const auto alone_product    = product(alone);
  const auto together_product = product(together);

  double       error = 0., mass = 0.;
  auto        &fields = together.fields;
  const double scale  = 3000 * 1.5; // mass and stress of all points
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      const unsigned int j =
        alone.fields.slot_of(node_alone(fields.active_nodes[i]));
      const auto &a = alone.fields.sums[j];
      const auto &b = fields.sums[i];
      error         = std::max({error,
                                std::abs(a.mass - b.mass),
                                (a.momentum - b.momentum).norm(),
                                (a.force - b.force).norm(),
                                (alone_product[j] - together_product[i]).norm()});
      if (fields.shared.counts(i))
        mass += b.mass;
    }
  error = Utilities::MPI::max(error, MPI_COMM_WORLD);
  mass  = Utilities::MPI::sum(mass, MPI_COMM_WORLD);

  // The lowest and the highest value over the ranks agree if all are the same.
  std::vector<double> lowest(alone.mesh.n_nodes(), 1e300),
    highest(alone.mesh.n_nodes(), -1e300);
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      const unsigned int node = node_alone(fields.active_nodes[i]);
      lowest[node] = highest[node] = fields.sums[i].force[0];
    }
  Utilities::MPI::min(lowest, MPI_COMM_WORLD, lowest);
  Utilities::MPI::max(highest, MPI_COMM_WORLD, highest);
  bool         same     = true;
  unsigned int n_active = 0;
  for (unsigned int node = 0; node < lowest.size(); ++node)
    if (lowest[node] < 1e300)
      {
        same = same && lowest[node] == highest[node];
        ++n_active;
      }

  double all_mass = 0.;
  for (const double m : alone.points.arrays().mass)
    all_mass += m;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << dim << "D" << (is_refined ? ", refined" : "")
              << ": as on one rank " << (error < 1e-12 * scale)
              << ", the same bits on all ranks " << same
              << ", all active nodes met "
              << (n_active == alone.fields.n_active_nodes())
              << ", each counted once "
              << (std::abs(mass - all_mass) < 1e-12 * all_mass) << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 8));
  test<3>(BoxMesh<3>("hypercubes", 6));
  test<2>(JitteredBox<2>(4), true);
  test<3>(JitteredBox<3>(4), true);
  test<2>(BoxMesh<2>("hypercubes", 8), true);
  test<3>(BoxMesh<3>("hypercubes", 6), true);
}
