// Boundary conditions on the nodes of a box: which components they prescribe,
// where several meet, moving ones, and the resultant of a traction.

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include "../box_mesh.h"

#include <mpm_granular/boundary/boundary_manager.h>

#include <iostream>

using namespace dealii;
using namespace mpm_granular;

template <int dim>
std::unique_ptr<Mesh::BackgroundMesh<dim>>
box(const std::string &cells)
{
  return std::make_unique<Mesh::BackgroundMesh<dim>>(
    Test::BoxMesh<dim>(cells, 3), "", MPI_COMM_SELF);
}

template <int dim>
struct Settings
{
  Boundary::BoundarySettings<dim> conditions{{}};

  explicit Settings(const std::string &entries)
  {
    for (unsigned int pass = 0; pass < 4; ++pass)
      {
        ParameterHandler prm;
        conditions.add_parameters(prm, "conditions");
        prm.parse_input_from_string(entries, "", true);
      }
    for (const auto &name : conditions.all_names())
      conditions[name].check();
  }
};

/// All cells active.
template <int dim>
void
activate(const Mesh::BackgroundMesh<dim> &mesh, Grid::NodalFields<dim> &fields)
{
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    fields.activate(c);
  fields.gather_nodes();
}

/// The velocity at a node after the conditions; before them it is (1, 2, 3).
template <int dim>
Tensor<1, dim>
velocity_at(const Point<dim>                     &place,
            const Mesh::BackgroundMesh<dim>      &mesh,
            const Grid::NodalFields<dim>         &fields,
            const Grid::VelocityConstraints<dim> &constraints)
{
  std::vector<Tensor<1, dim>> velocity(fields.n_active_nodes());
  for (auto &v : velocity)
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = d + 1.;
  if (constraints.has_contact)
    constraints.resolve_contact(velocity);
  else
    constraints.apply(velocity);
  for (unsigned int i = 0; i < velocity.size(); ++i)
    if (mesh.node_position(fields.active_nodes[i]).distance(place) < 1e-9)
      return velocity[i];
  return {};
}

template <int dim>
void
test(const std::string &cells)
{
  const auto                 mesh = box<dim>(cells);
  const Mesh::Partition<dim> partition({}, *mesh, MPI_COMM_SELF);
  Grid::NodalFields<dim>     fields(*mesh, partition);
  activate(*mesh, fields);
  const std::string others = dim == 2 ? "" : ", z_min, z_max";

  const Settings<dim> settings(
    "set Names = base, side, moving, open\n"
    "subsection base\n set Boundaries = y_min\n set Type = clamp\nend\n"
    "subsection side\n set Boundaries = x_min\n set Type = roller\nend\n"
    "subsection moving\n set Boundaries = x_max\n"
    " set Type = prescribed displacement\n set Displacement = 3*t^2; 0" +
    std::string(dim == 2 ? "" : "; 0") +
    "\n set Components = x\nend\n"
    "subsection open\n set Boundaries = y_max" +
    others + "\n set Type = free\nend\n");
  Boundary::BoundaryManager<dim> manager(settings.conditions,
                                         *mesh,
                                         MPI_COMM_SELF);
  manager.update(fields, 1., .5);
  const auto at = [&](const double x, const double y) {
    Point<dim> place;
    place[0] = x;
    place[1] = y;
    if (dim == 3)
      place[2] = 1. / 3.;
    return velocity_at(place, *mesh, fields, manager.constraints());
  };
  std::cout << dim << "D, " << cells << std::endl
            << "inside " << at(1. / 3., 1. / 3.) << std::endl
            << "base " << at(1. / 3., 0.) << std::endl
            << "side " << at(0., 1. / 3.) << std::endl
            << "base and side " << at(0., 0.) << std::endl
            << "moving, 7.5 by the difference quotient " << at(1., 1. / 3.)
            << std::endl
            << "base before moving " << at(1., 0.) << std::endl;

  // Before the walls the velocity is (1, 2, 3): it leaves the lower one, and
  // the upper one takes the normal part 2, and 0.25 * 2 of the speed along it.
  const Settings<dim>            rough("set Names = lower, upper, open\n"
                                       "subsection lower\n set Boundaries = y_min\n"
                                       " set Type = Coulomb friction\nend\n"
                                       "subsection upper\n set Boundaries = y_max\n"
                                       " set Type = Coulomb friction\n"
                                       " set Friction coefficient = 0.25\nend\n"
                                       "subsection open\n set Boundaries = x_min, x_max" +
                            others + "\n set Type = free\nend\n");
  Boundary::BoundaryManager<dim> walls(rough.conditions, *mesh, MPI_COMM_SELF);
  walls.update(fields, 1., .5);
  for (const double y : {0., 1.})
    {
      Point<dim> place;
      place[0] = 1. / 3.;
      place[1] = y;
      if (dim == 3)
        place[2] = 1. / 3.;
      std::cout << "Coulomb friction "
                << velocity_at(place, *mesh, fields, walls.constraints())
                << std::endl;
    }

  // What is prescribed then: nothing on the lower wall; of (1, 2, 3) a normal
  // component on the upper one, which keeps its value, and all components where
  // friction can stop sqrt(10) and more.
  for (const std::string coefficient : {"0.25", "1.6"})
    {
      const Settings<dim>            one_wall("set Names = upper, open\n"
                                              "subsection upper\n"
                                              " set Boundaries = y_max\n"
                                              " set Type = Coulomb friction\n"
                                              " set Friction coefficient = " +
                                   coefficient +
                                   "\nend\n"
                                              "subsection open\n"
                                              " set Boundaries = x_min, x_max, y_min" +
                                   others + "\n set Type = free\nend\n");
      Boundary::BoundaryManager<dim> wall(one_wall.conditions,
                                          *mesh,
                                          MPI_COMM_SELF);
      wall.update(fields, 1., .5);
      std::vector<Tensor<1, dim>> velocity(fields.n_active_nodes());
      for (auto &v : velocity)
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = d + 1.;
      const auto held = wall.constraints().resolve_contact(velocity);
      std::cout << "friction " << coefficient << ": " << held.nodes.size()
                << " nodes of " << wall.constraints().nodes.size() << " with "
                << held.nodes.front().n_directions << " components, "
                << velocity[held.nodes.front().slot] << std::endl;
      for (auto &v : velocity)
        v = Point<dim>::unit_vector(0) - Point<dim>::unit_vector(1);
      held.apply(velocity);
      std::cout << "afterwards " << velocity[held.nodes.front().slot]
                << std::endl;
    }
  walls.update_at_rest(fields);
  manager.update_at_rest(fields);
  std::cout << "moving wall, at rest " << at(1., 1. / 3.) << std::endl;

  try
    {
      const Settings<dim> too_few(
        "set Names = base\n"
        "subsection base\n set Boundaries = y_min, x_min" +
        others + "\n set Type = clamp\nend\n");
      Boundary::BoundaryManager<dim>(too_few.conditions, *mesh, MPI_COMM_SELF);
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
  try
    {
      const Settings<dim> unknown(
        "set Names = base\n"
        "subsection base\n set Boundaries = bottom\n set Type = clamp\nend\n");
      Boundary::BoundaryManager<dim>(unknown.conditions, *mesh, MPI_COMM_SELF);
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }

  // The resultant of t_y = -4 x y t on the side of y = 1 is -2 t, its first
  // moment about the origin, of x, is -4/3 t.
  const Settings<dim> loaded(
    "set Names = load, rest\n"
    "subsection load\n set Boundaries = y_max\n set Type = traction\n"
    " set Traction = 0; -4*x*y*t" +
    std::string(dim == 2 ? "" : "; 0") +
    "\nend\n"
    "subsection rest\n set Boundaries = x_min, x_max, y_min" +
    others + "\n set Type = free\nend\n");
  Boundary::BoundaryManager<dim> loading(loaded.conditions,
                                         *mesh,
                                         MPI_COMM_SELF);
  loading.add_tractions(fields, 2.);
  Tensor<1, dim> resultant;
  double         first_moment = 0.;
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      resultant += fields.sums[i].load;
      first_moment +=
        mesh->node_position(fields.active_nodes[i])[0] * fields.sums[i].load[1];
    }
  std::cout << "traction " << resultant << ", moment " << first_moment
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *cells : {"simplices", "hypercubes"})
    {
      test<2>(cells);
      test<3>(cells);
    }
}
