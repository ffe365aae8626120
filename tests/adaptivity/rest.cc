// A mesh that is adapted to a body again and again comes to rest: no cell is
// divided and undone in turn, whatever the criterion; also after the body has
// moved on. It is the same on any number of ranks; on three in Release only: in
// Debug criteria.cc and levels.cc take the same ways through the code on three.

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"

#include <mpm_granular/adaptivity/adaptation.h>
#include <mpm_granular/parameters/parameter_file.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace Test;

namespace
{
  /// A ball of points on a grid of places that has nothing to do with the
  /// cells; sheared in a narrow band across it.
  template <int dim>
  class Body
  {
  public:
    explicit Body(const std::string &cells)
      : mesh(BoxMesh<dim>(cells, dim == 2 ? 9 : 5), "", MPI_COMM_WORLD)
      , partition({}, mesh, MPI_COMM_WORLD)
      , fields(mesh, partition)
    {}

    /// Adapts the mesh until it stays.
    /// @return how often it changed, or none if it does not stay.
    std::string
    adapt(Adaptivity::Adaptation<dim> &adaptation, const double center)
    {
      constexpr unsigned int too_often = 12;
      for (unsigned int n = 0; n < too_often; ++n)
        if (!adapt_once(adaptation, center))
          return std::to_string(n) + " times";
      return "DOES NOT STAY";
    }

    /// Cells by level.
    std::string
    report() const
    {
      std::vector<unsigned int> numbers(5, 0);
      for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
        ++numbers[mesh.level(cell)];
      if (mesh.is_distributed())
        Utilities::MPI::sum(numbers, MPI_COMM_WORLD, numbers);
      while (numbers.back() == 0)
        numbers.pop_back();
      std::string text;
      for (const unsigned int number : numbers)
        text += " " + std::to_string(number);
      return text;
    }

  private:
    bool
    adapt_once(Adaptivity::Adaptation<dim> &adaptation, const double center)
    {
      const auto n_points = count(center);
      fields.reinit();
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        if (n_points[cell] > 0 && partition.is_owned(cell))
          fields.activate(cell);
      fields.gather_nodes();
      for (const unsigned int node : fields.active_nodes)
        {
          auto &sums = fields.sums[fields.slot_of(node)];
          sums.mass  = 1.;
          sums.momentum[0] =
            std::tanh((mesh.node_position(node)[1] - .41) / .05);
        }
      const Adaptivity::State<dim> state(
        mesh, partition, fields, n_points, center);
      if (!mesh.adapt(adaptation.wanted_levels(state)))
        return false;
      partition.distribute(std::vector<std::uint32_t>(mesh.n_cells(), 1));
      return true;
    }

    std::vector<std::uint32_t>
    count(const double center) const
    {
      constexpr double        radius = .23, spacing = dim == 2 ? .0217 : .0417;
      std::vector<Point<dim>> places;
      const int               n = radius / spacing;
      Point<dim>              middle;
      for (unsigned int d = 0; d < dim; ++d)
        middle[d] = d == 0 ? center : .43;
      for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
          for (int k = dim == 2 ? 0 : -n; k <= (dim == 2 ? 0 : n); ++k)
            {
              Point<dim> place = middle;
              place[0] += spacing * i;
              place[1] += spacing * j;
              place[dim - 1] += spacing * k;
              if (place.distance(middle) < radius)
                places.push_back(place);
            }
      std::vector<std::uint32_t> numbers(mesh.n_cells(), 0);
      for (const unsigned int cell : mesh.locate(places))
        if (cell < mesh.n_cells())
          ++numbers[cell];
      return numbers;
    }

    Mesh::BackgroundMesh<dim> mesh;
    Mesh::Partition<dim>      partition;
    Grid::NodalFields<dim>    fields;
  };
} // namespace

template <int dim>
void
test(const std::string              &cells,
     const std::string              &name,
     const std::vector<std::string> &entries)
{
  std::vector<std::string> all{"Names=it",
                               "Maximum level=" + std::to_string(5 - dim)};
  all.insert(all.end(), entries.begin(), entries.end());
  Adaptivity::AdaptationParameters<dim> parameters;
  Parameters::read(parameters, "", all);
  parameters.check();
  Adaptivity::Adaptation<dim> adaptation(parameters);

  Body<dim>   body(cells);
  std::string text = std::to_string(dim) + "D, " + cells + ", " + name + ":";
  // Points on diagonal faces of tetrahedra are on one side or the other by
  // round-off; without layers that decides how many cells there are.
  const bool has_ties = dim == 3 && cells == "simplices" && name == "no layers";
  for (const double center : {.3, .33, .7})
    {
      text += " " + body.adapt(adaptation, center);
      text += (adaptation.is_limited() ? " (limited)" : "") +
              (has_ties ? "" : body.report()) + ";";
    }
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << text << std::endl;
}

template <int dim>
void
test(const std::string &cells)
{
  test<dim>(cells, "points", {"it/Largest number of points=6"});
  test<dim>(cells, "free surface", {"it/Type=free surface"});
  test<dim>(cells,
            "shear",
            {"it/Type=shear", "it/Largest jump=0.3", "it/Coarsening part=0.5"});
  test<dim>(cells,
            "distance",
            {"it/Type=distance", "it/Surface=x-t+0.2*y", "it/Distance=0.03"});
  test<dim>(cells,
            "region",
            {"it/Type=region", "it/Level=if(x+0.3*y<t, 3, if(y>0.83, 1, 0))"});
  test<dim>(cells,
            "no layers",
            {"Buffer layers=0", "Kept layers=0", "Interval displacement=0"});
  test<dim>(cells, "few cells", {"Maximum number of cells=500"});
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("hypercubes");
  test<2>("simplices");
  test<3>("hypercubes");
  test<3>("simplices");
}
