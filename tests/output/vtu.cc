// VTU files of points and grid: the values of all fields against hand
// calculations, the number of pieces, points and cells, the names of the
// fields, the record over time, the estimated size, and the refusal of fields
// that do not exist.

#include <deal.II/base/mpi.h>

#include "../observables/hand_made_body.h"

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/grid_output.h>
#include <mpm_granular/output/points_output.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>

using namespace Test;

/// Prints what the group of @p pattern finds in the file before the arrays of a
/// VTU file, one a line.
void
print_matches(const std::string &path, const std::string &pattern)
{
  std::ifstream      file(path);
  std::ostringstream text;
  text << file.rdbuf();
  const std::string contents =
    text.str().substr(0, text.str().find("<AppendedData"));
  const std::regex wanted(pattern);
  for (std::sregex_iterator match(contents.begin(), contents.end(), wanted),
       end;
       match != end;
       ++match)
    std::cout << "  " << match->str(1) << std::endl;
}



template <int dim>
void
print_fields()
{
  const SimpleLaw<dim>    sand(1500., {"strain", "log_volume_ratio"});
  const SimpleLaw<dim>    rock(3000., {"log_volume_ratio"});
  const Output::Laws<dim> laws{&sand, &rock};

  Points::PointArrays<dim> points;
  points.resize(2, 2);
  for (unsigned int i = 0; i < 2; ++i)
    {
      for (unsigned int d = 0; d < dim; ++d)
        points.velocity[d][i] = (d + 1.) * (i + 1.);
      const double stress[6] = {-1., -2., -6., 1., 2., 3.};
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        points.stress[c][i] = stress[c] * (i + 1.);
      points.history[0][i] = 10. + i;
      points.history[1][i] = 20. + i;
      points.mass[i]       = 3.;
      points.volume[i]     = 0.001 * (i + 1.);
      points.material[i]   = i;
      points.id[i]         = 5 + i;
    }
  for (const auto &field : Output::point_fields(points, laws))
    {
      std::cout << "  " << field.name << " [" << field.unit << "]";
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int c = 0; c < field.n_components; ++c)
          std::cout << " " << field.value(i, c);
      std::cout << std::endl;
    }
}



void
write_points(const Output::OutputParameters &parameters)
{
  const SimpleLaw<3>      law(1500., {"strain"});
  const Output::Laws<3>   laws{&law};
  Output::PointsOutput<3> output(parameters, laws, MPI_COMM_SELF);
  Points::PointArrays<3>  points;
  points.resize(70000, 1);
  output.write(0., 0, points);
  points.resize(2, 1);
  output.write(0.5, 10, points);
  points.resize(0, 1);
  output.write(1., 20, points);
  std::cout << "Files: " << output.n_files() << std::endl;
  std::cout << "Estimated size over that of the first: "
            << std::lround(100. * output.estimated_file_size(70000) /
                           std::filesystem::file_size(
                             parameters.directory + "/points/points-00000.vtu"))
            << " %" << std::endl;
  for (const std::string number : {"0", "1", "2"})
    {
      const std::string file =
        parameters.directory + "/points/points-0000" + number + ".vtu";
      std::cout << file << std::endl;
      print_matches(file, "<Piece ([^>]*)>");
      print_matches(file, "Name=\"TIME\"[^>]*>([^<]*)<");
    }
  std::cout << "Arrays of the second file" << std::endl;
  print_matches(parameters.directory + "/points/points-00001.vtu",
                " Name=\"([^\"]*)\"");
  std::cout << "Record" << std::endl;
  print_matches(parameters.directory + "/points.pvd",
                "<DataSet (timestep[^>]*)/>");
}



template <int dim>
void
write_grid(const Output::OutputParameters &parameters)
{
  std::vector<unsigned int> subdivisions(dim, 2);
  Point<dim>                corner;
  for (unsigned int d = 0; d < dim; ++d)
    corner[d] = 1.;
  Body<dim>                  body(Point<dim>(), corner, subdivisions);
  const Mesh::Partition<dim> partition({}, body.mesh, MPI_COMM_SELF);
  Output::GridOutput<dim>    output(parameters, MPI_COMM_SELF);
  output.write(
    0.25,
    3,
    body.mesh,
    partition,
    {{"mass",
      "kg",
      1,
      [](const std::size_t, const unsigned int) { return 2.; }},
     {"velocity", "m/s", dim, [](const std::size_t, const unsigned int d) {
        return 1. * d;
      }}});
  const std::string file = parameters.directory + "/grid/grid-00000.vtu";
  print_matches(file, "<Piece ([^>]*)>");
  print_matches(file, " Name=\"([^\"]*)\"");
  print_matches(parameters.directory + "/grid.pvd",
                "<DataSet (timestep[^>]*)/>");
}



void
try_fields(const std::vector<std::string> &fields)
{
  const SimpleLaw<2>       law(1500.);
  Output::OutputParameters parameters;
  parameters.point_fields = fields;
  try
    {
      const Output::PointsOutput<2> output(parameters, {&law}, MPI_COMM_SELF);
      for (const auto &name : output.field_names())
        std::cout << "  " << name << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << "  " << error.what() << std::endl;
    }
}



int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all("run");
  Output::OutputParameters parameters;
  parameters.directory = "run";

  std::cout << "Fields in 2D" << std::endl;
  print_fields<2>();
  std::cout << "Fields in 3D" << std::endl;
  print_fields<3>();

  write_points(parameters);
  std::cout << "Grid in 2D" << std::endl;
  write_grid<2>(parameters);
  std::cout << "Grid in 3D" << std::endl;
  write_grid<3>(parameters);

  std::cout << "Chosen fields" << std::endl;
  try_fields({"id", "stress", "velocity"});
  std::cout << "Fields that do not exist" << std::endl;
  try_fields({"velocity", "temperature"});
  try_fields({"presure"});
}
