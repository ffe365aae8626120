#include <deal.II/grid/grid_generator.h>

#include <mpm_granular/mesh/box.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  template <int dim>
  Box<dim>::Box()
    : subdivisions(dim, 10)
  {
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1.;
  }

  template <int dim>
  void
  Box<dim>::add_parameters(ParameterHandler &prm)
  {
    MeshSource<dim>::add_parameters(prm);
    prm.add_parameter("Lower corner",
                      lower,
                      "Corner with the smallest coordinates. Units: m.");
    prm.add_parameter("Upper corner",
                      upper,
                      "Corner with the largest coordinates. Units: m.");
    prm.add_parameter("Subdivisions",
                      subdivisions,
                      "Number of subdivisions in each direction; each one is a "
                      "hypercube or is split into 2 triangles or 5 tetrahedra.",
                      Patterns::List(Patterns::Integer(1), dim, dim));
  }

  template <int dim>
  void
  Box<dim>::check() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      require(lower[d] < upper[d],
              "Mesh/Upper corner must lie above Mesh/Lower corner in every "
              "direction; in direction " +
                std::to_string(d) + " they are " + std::to_string(upper[d]) +
                " and " + std::to_string(lower[d]) + ".");
  }

  template <int dim>
  MeshNames
  Box<dim>::make(Triangulation<dim> &triangulation,
                 const std::string & /*input_file*/) const
  {
    if (this->cell_kind() == CellKind::simplex)
      {
        GridGenerator::subdivided_hyper_rectangle_with_simplices(triangulation,
                                                                 subdivisions,
                                                                 lower,
                                                                 upper);
        mark_boundaries(triangulation);
      }
    else
      {
        // As few coarse cells as can be: every process holds all of these.
        std::vector<unsigned int> coarse        = subdivisions;
        unsigned int              n_refinements = 0;
        const auto is_even = [](const unsigned int n) { return n % 2 == 0; };
        for (; std::all_of(coarse.begin(), coarse.end(), is_even);
             ++n_refinements)
          for (unsigned int &n : coarse)
            n /= 2;
        GridGenerator::subdivided_hyper_rectangle(triangulation,
                                                  coarse,
                                                  lower,
                                                  upper);
        mark_boundaries(triangulation);
        triangulation.refine_global(n_refinements);
      }

    MeshNames         names;
    const std::string axes = "xyz";
    for (unsigned int d = 0; d < dim; ++d)
      {
        names.boundaries[axes.substr(d, 1) + "_min"] = 2 * d;
        names.boundaries[axes.substr(d, 1) + "_max"] = 2 * d + 1;
      }
    return names;
  }

  template <int dim>
  void
  Box<dim>::mark_boundaries(Triangulation<dim> &triangulation) const
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          {
            const Point<dim> center = cell->face(f)->center();
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double tolerance = 1e-9 * (upper[d] - lower[d]);
                if (std::abs(center[d] - lower[d]) < tolerance)
                  cell->face(f)->set_boundary_id(2 * d);
                else if (std::abs(center[d] - upper[d]) < tolerance)
                  cell->face(f)->set_boundary_id(2 * d + 1);
              }
          }
  }

  template class Box<2>;
  template class Box<3>;

  namespace
  {
    const std::string documentation =
      "a box of equal cells with boundaries x_min, x_max, y_min, ...";
    const MeshSourceRegistry<2>::Entry<Box<2>> box_2d("box", documentation);
    const MeshSourceRegistry<3>::Entry<Box<3>> box_3d("box", documentation);
  } // namespace
} // namespace mpm_granular::Mesh
