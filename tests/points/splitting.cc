// Points in two halves where cells have too few: the sums over the points, and
// those at the nodes, stay; halves are in their cells; ids are new, and the
// same on any number of ranks.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include "../transfer/scattered_points.h"

#include <mpm_granular/points/splitting.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>

using namespace Test;

namespace
{
  /// Parallelograms, parallelepipeds.
  template <int dim>
  class SkewedBox : public BoxMesh<dim>
  {
  public:
    using BoxMesh<dim>::BoxMesh;

    Mesh::MeshNames
    make(Triangulation<dim> &triangulation,
         const std::string  &input_file) const override
    {
      const auto names = Mesh::Box<dim>::make(triangulation, input_file);
      GridTools::transform(
        [](Point<dim> x) {
          x[0] += .3 * x[1];
          x[dim - 1] += .1 * x[0];
          return x;
        },
        triangulation);
      return names;
    }
  };

  /// Mass, volume, momentum, sum of m x, angular momentum about the corner,
  /// kinetic energy, sum of V sigma: of all points, over the ranks.
  template <int dim>
  std::vector<double>
  sums_of(const ScatteredPoints<dim> &test)
  {
    const auto         &points = test.points.arrays();
    std::vector<double> sums(2 + 2 * dim + 9 + 1 + n_stress<dim>, 0.);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const double m   = points.mass[p];
        double      *sum = sums.data();
        *sum++ += m;
        *sum++ += points.volume[p];
        for (unsigned int d = 0; d < dim; ++d)
          {
            *sum++ += m * points.velocity[d][p];
            *sum++ += m * points.position[d][p];
          }
        double square = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            square += points.velocity[d][p] * points.velocity[d][p];
            for (unsigned int e = 0; e < dim; ++e)
              sum[3 * d + e] +=
                m * (points.position[d][p] * points.velocity[e][p] -
                     points.position[e][p] * points.velocity[d][p]);
          }
        sum += 9;
        *sum++ += .5 * m * square;
        for (const auto &component : points.stress)
          *sum++ += points.volume[p] * component[p];
      }
    Utilities::MPI::sum(sums, MPI_COMM_WORLD, sums);
    return sums;
  }

  /// Mass, momentum and force by place of the node.
  template <int dim>
  std::map<std::array<long, dim>, std::array<double, 1 + 2 * dim>>
  nodes_of(ScatteredPoints<dim> &test)
  {
    std::map<std::array<long, dim>, std::array<double, 1 + 2 * dim>> nodes;
    test.project();
    for (unsigned int i = 0; i < test.fields.n_active_nodes(); ++i)
      {
        const auto &x    = test.mesh.node_position(test.fields.active_nodes[i]);
        const auto &sums = test.fields.sums[i];
        std::array<long, dim> key;
        for (unsigned int d = 0; d < dim; ++d)
          key[d] = std::lround(1e9 * x[d]);
        auto &values = nodes[key];
        values[0]    = sums.mass;
        for (unsigned int d = 0; d < dim; ++d)
          {
            values[1 + d]       = sums.momentum[d];
            values[1 + dim + d] = sums.force[d];
          }
      }
    return nodes;
  }
} // namespace

template <int dim>
void
test(const std::string &name, const Mesh::MeshSource<dim> &source)
{
  const unsigned int least    = 4;
  const auto         velocity = [](const Point<dim> &x) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = std::sin(5. * x[d]) + x[(d + 1) % dim];
    return v;
  };
  ScatteredPoints<dim> test(source, velocity, MPI_COMM_WORLD);
  auto                &arrays = test.points.arrays();
  const auto           all    = [](const double value) {
    return Utilities::MPI::sum(value, MPI_COMM_WORLD);
  };
  const double n_before = all(arrays.size());
  const auto   sums     = sums_of(test);
  const auto   nodes    = nodes_of(test);
  const double n_new    = all(test.points.split(least));

  const auto new_sums  = sums_of(test);
  const auto new_nodes = nodes_of(test);
  double     error = 0., node_error = 0.;
  for (unsigned int i = 0; i < sums.size(); ++i)
    error = std::max(error, std::abs(new_sums[i] - sums[i]) / sums[0]);
  for (const auto &[place, values] : nodes)
    for (unsigned int i = 0; i < values.size(); ++i)
      node_error =
        std::max(node_error, std::abs(values[i] - new_nodes.at(place)[i]));
  node_error = Utilities::MPI::max(node_error, MPI_COMM_WORLD);

  // Where they are, and how many in a cell.
  double                 lowest = 1.;
  std::vector<unsigned>  n_in_cell(test.mesh.n_cells(), 0);
  unsigned int           n_poor = 0;
  double                 of_ids = 0.;
  std::set<unsigned int> ids;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      ++n_in_cell[arrays.cell[p]];
      ids.insert(arrays.id[p]);
      of_ids += arrays.position[0][p] * (arrays.id[p] % 1000);
      test.mesh.visit([&](const auto &cells) {
        for (const double height :
             cells[arrays.cell[p]].heights(arrays.location(p)))
          lowest = std::min(lowest, height);
      });
    }
  for (const unsigned int n : n_in_cell)
    if (n > 0 && n < least)
      ++n_poor;
  const auto all_ids = Utilities::MPI::compute_set_union(ids, MPI_COMM_WORLD);
  lowest             = Utilities::MPI::min(lowest, MPI_COMM_WORLD);
  const double n = all(arrays.size()), poor = all(n_poor), by_id = all(of_ids);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << name << ", " << dim << "D: " << n_before << " points and "
              << n_new << " new are " << n << ", ids " << all_ids.size()
              << " to " << *all_ids.rbegin() << ", by id " << by_id
              << "; cells with too few " << poor << "\n  sums stay "
              << (error < 1e-13) << ", nodes as well "
              << (node_error < 1e-11 * sums[0]) << ", inside " << (lowest >= 0.)
              << std::endl;
}

/// A point in the middle of a box, and one in its corner.
template <int dim>
void
show()
{
  const Mesh::BackgroundMesh<dim> mesh(BoxMesh<dim>("hypercubes", 1),
                                       "",
                                       MPI_COMM_SELF);
  Points::PointArrays<dim>        points;
  points.resize(1, 1);
  points.volume[0]  = 1.;
  points.history[0] = {7.};
  for (auto &component : points.position)
    component[0] = .5;
  for (const unsigned int least : {1, 2, 4})
    std::cout << Points::split(mesh, points, least) << " new"
              << (least == 4 ? ":" : ", ");
  for (unsigned int p = 0; p < points.size(); ++p)
    std::cout << " (" << points.location(p) << ") " << points.volume[p] << ' '
              << points.history[0][p] << ' ' << points.id[p];
  std::cout << std::endl;

  points.resize(1, 1);
  for (auto &component : points.position)
    component[0] = 1.;
  std::cout << "in a corner " << Points::split(mesh, points, 4) << " new"
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("triangles", JitteredBox<2>(40));
  test<3>("tetrahedra", JitteredBox<3>(7));
  test<2>("parallelograms", SkewedBox<2>("hypercubes", 31));
  test<3>("parallelepipeds", SkewedBox<3>("hypercubes", 13));
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      std::cout << std::setprecision(8);
      show<2>();
      show<3>();
    }
}
