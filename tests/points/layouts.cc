// Points of a region: volumes add up to the region's, symmetric layouts
// integrate linear functions exactly and, from 3 (2D) or 4 (3D) points on,
// those of degree two as far as they claim; Gauss points all but single ones.

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include "../box_mesh.h"
#include "../jittered_box.h"

#include <mpm_granular/points/region.h>

#include <iostream>

using namespace Test;

template <int dim>
std::vector<Points::Seed<dim>>
fill(const Mesh::BackgroundMesh<dim> &mesh, const std::string &entries)
{
  Points::Region<dim> region;
  for (unsigned int pass = 0; pass < 2; ++pass)
    {
      ParameterHandler prm;
      region.add_parameters(prm);
      prm.parse_input_from_string(entries, "", true);
    }
  region.check();
  return region.fill(mesh, "");
}

/// Integrals over the unit box by points of a layout: of x_0 it is 1/2.
template <int dim>
void
integrate(const Mesh::BackgroundMesh<dim> &mesh,
          const std::string               &layout,
          const std::vector<unsigned int> &points_per_cell)
{
  for (const unsigned int n : points_per_cell)
    {
      double     volume = 0., first = 0., second = 0.;
      const auto seeds = fill(mesh,
                              "set Layout = " + layout +
                                "\nset Points per cell = " + std::to_string(n));
      for (const auto &seed : seeds)
        {
          volume += seed.volume;
          first += seed.volume * seed.position[0];
          second += seed.volume * seed.position[0] * seed.position[0];
        }
      std::cout << dim << "D, " << n
                << " per cell: " << seeds.size() / double(mesh.n_cells())
                << ", volume " << volume << ", x " << first << ", x^2 exact "
                << (std::abs(second - 1. / 3.) < 1e-12) << std::endl;
    }
}

template <int dim>
void
test(const Mesh::MeshSource<dim>     &source,
     const std::vector<unsigned int> &points_per_cell,
     const std::vector<unsigned int> &gauss_points)
{
  const Mesh::BackgroundMesh<dim> mesh(source, "");
  integrate(mesh, "symmetric", points_per_cell);
  if (gauss_points.empty())
    try
      {
        integrate(mesh, "Gauss", {4});
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  else
    {
      std::cout << "Gauss" << std::endl;
      integrate(mesh, "Gauss", gauss_points);
    }

  const std::string spacing = dim == 2 ? "0.1, 0.2" : "0.1, 0.2, 0.25";
  double            volume  = 0.;
  const auto        seeds =
    fill(mesh, "set Layout = lattice\nset Spacing = " + spacing);
  for (const auto &seed : seeds)
    volume += seed.volume;
  std::cout << "lattice: " << seeds.size() << ", volume " << volume
            << std::endl;

  // Balls: a part of one in the mesh, and the volume of a whole one.
  const std::string fine      = dim == 2 ? "0.02, 0.02" : "0.02, 0.02, 0.02";
  double            part      = 0.;
  bool              is_inside = true;
  for (const auto &seed :
       fill(mesh,
            "set Shape = ball\nset Radius = 0.8\nset Points per cell = " +
              std::to_string(points_per_cell.back())))
    is_inside = is_inside && seed.position.norm() < 0.8;
  const std::string center = dim == 2 ? "0.5, 0.5" : "0.5, 0.5, 0.5";
  for (const auto &seed : fill(
         mesh,
         "set Shape = ball\nset Center = " + center +
           "\nset Radius = 0.4\nset Layout = lattice\nset Spacing = " + fine))
    part += seed.volume;
  const double whole =
    dim == 2 ? numbers::PI * 0.16 : numbers::PI * 0.064 * 4. / 3.;
  std::cout << "ball: points inside " << is_inside << ", volume within 1 % "
            << (std::abs(part / whole - 1.) < 0.01) << std::endl;

  try
    {
      fill(mesh,
           "set Layout = lattice\nset Upper corner = 2" +
             std::string(dim == 2 ? ", 1" : ", 1, 1") +
             "\nset Spacing = " + spacing);
      std::cout << "points outside the mesh were accepted" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(3), {1, 3, 4, 9, 16}, {});
  test<3>(JitteredBox<3>(3), {1, 4, 8, 16}, {});
  test<2>(BoxMesh<2>("hypercubes", 3), {1, 4, 9, 16}, {1, 4, 9});
  test<3>(BoxMesh<3>("hypercubes", 3), {1, 8, 27, 64}, {1, 8, 27});

  try
    {
      const Mesh::BackgroundMesh<3> mesh(BoxMesh<3>("hypercubes", 3), "");
      fill(mesh, "set Points per cell = 4");
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}
