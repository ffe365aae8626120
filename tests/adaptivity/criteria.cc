// What the criteria want on a uniform box, on any number of ranks. Hypercubes
// are counted by hand (comments); 2 triangles, 5 tetrahedra make a hypercube.

#include "state_on_box.h"

#include <sstream>

using namespace Test;

namespace
{
  /// The number and place of cells that touch a set of others, itself not in
  /// the set, found by comparing the places of vertices of all pairs of cells.
  template <int dim>
  std::string
  count_touching(const Mesh::MeshSource<dim>                   &source,
                 const std::function<bool(const Point<dim> &)> &is_in)
  {
    const StateOnBox<dim> alone(source, MPI_COMM_SELF);
    const auto           &mesh = alone.mesh;
    return alone.report([&](const unsigned int cell) {
      if (is_in(alone.center(cell)))
        return 0u;
      for (unsigned int other = 0; other < mesh.n_cells(); ++other)
        if (is_in(alone.center(other)))
          for (const unsigned int a : mesh.nodes(cell))
            for (const unsigned int b : mesh.nodes(other))
              if (mesh.node_position(a).distance(mesh.node_position(b)) < 1e-9)
                return 1u;
      return 0u;
    });
  }

  /// A box with boundary 7, that part of the bottom where x < 0.4.
  template <int dim>
  class PartOfBottom : public BoxMesh<dim>
  {
  public:
    using BoxMesh<dim>::BoxMesh;

    Mesh::MeshNames
    make(Triangulation<dim> &triangulation,
         const std::string  &input_file) const override
    {
      const auto names = Mesh::Box<dim>::make(triangulation, input_file);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && cell->face(f)->boundary_id() == 2 &&
              cell->face(f)->center()[0] < .39)
            cell->face(f)->set_boundary_id(7);
      return names;
    }
  };
} // namespace

template <int dim>
void
test(const std::string &cells)
{
  print(std::to_string(dim) + "D, " + cells);
  const BoxMesh<dim> box(cells, 5);
  StateOnBox<dim>    test(box);

  // x in the columns .1, .3, .5, .7, .9 of hypercubes.
  test.set_points([](const Point<dim> &x) {
    const unsigned int most = 1 << dim;
    return x[0] < .2 ? 0 :
           x[0] < .4 ? most :
           x[0] < .6 ? most + 1 :
           x[0] < .8 ? most * most :
                       most * most + 1;
  });
  // Two columns of level 1 (2 * 5^(dim-1) hypercubes) and one of level 2.
  print("points" +
        test.ask("points",
                 {"Largest number of points=" + std::to_string(1 << dim)}));
  print("at most 1" + test.ask("points", {}));

  const auto is_empty = [](const Point<dim> &x) {
    return x[0] > .6 || x[1] > .8;
  };
  test.set_points([&](const Point<dim> &x) { return is_empty(x) ? 0 : 3; });
  // A column and a row of hypercubes, 3 + 4 - 1 in 2D.
  print("free surface" + test.ask("free surface", {"Level=1"}));
  print("  from pairs" + count_touching<dim>(box, is_empty));

  // gamma = 3, so the jump is 3 * 0.2 of the speed 3 at the top; if hypercubes,
  // in all; larger in the inner one of five tetrahedra.
  const auto sheared = [](const Point<dim> &x) {
    Tensor<1, dim> v;
    v[0] = 3. * x[1];
    return v;
  };
  const auto everywhere = [](const Point<dim> &) { return 1; };
  test.set_points(everywhere, sheared);
  print("shear, 0.21" + test.ask("shear", {"Largest jump=0.21"}));
  print("shear, 0.19" + test.ask("shear", {"Largest jump=0.19"}));
  print("shear, 0.19, slow" +
        test.ask("shear", {"Largest jump=0.19", "Speed=3.5"}));
  print("shear, level 0" + test.ask("shear", {"Largest jump=0.19", "Level=0"}));
  // In 3D uniform expansion is no shear; in plane strain it is,
  // sqrt(4/3) * 0.2 of the speed sqrt(2) at the corner: 0.1633.
  test.set_points(everywhere, [](const Point<dim> &x) { return x; });
  print("expansion, 0.163" + test.ask("shear", {"Largest jump=0.163"}));
  print("expansion, 0.164" + test.ask("shear", {"Largest jump=0.164"}));

  // Vertices with y = 0 and 0.2: two rows; 0.4 is not less than 0.4.
  print("bottom" +
        test.ask("distance", {"Boundaries=y_min", "Distance=0.4", "Level=3"}));
  // One row and one column: 5 + 5 - 1 hypercubes in 2D.
  print("corner" +
        test.ask("distance", {"Boundaries=x_max, y_min", "Distance=0.1"}));
  print("plane surface" +
        test.ask("distance", {"Surface=x-0.5", "Distance=0.09"}));
  // That part ends at x = 0.4, so it is near to vertices with x up to 0.6 if
  // y = 0, up to 0.4 if y = 0.2: rows of 4 and 3 hypercubes.
  StateOnBox<dim> with_part(PartOfBottom<dim>(cells, 5));
  print("part of the bottom" +
        with_part.ask("distance", {"Boundaries=7", "Distance=0.21"}));

  test.set_points(everywhere, sheared, 2.);
  // Vertices up to x = 0.6, and the others up to y = 0.4.
  print("region" +
        test.ask("region", {"Level=if(x<0.3*t+0.01, 3.2, if(y<0.41, 2, 0))"}));
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("hypercubes");
  test<2>("simplices");
  test<3>("hypercubes");
  test<3>("simplices");
  try
    {
      StateOnBox<2>(BoxMesh<2>("simplices", 2)).ask("distance", {});
    }
  catch (const InputError &error)
    {
      print(error.what());
    }
}
