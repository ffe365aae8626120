// Files of points that several ranks write, one of them with more than one
// piece and one with none: rows and values of HDF5 files, ids above 2^24
// exactly, the XDMF and PVTU files that name them, points chosen by their ids.
// An error on one rank is one of all.

#include "../observables/hand_made_body.h"

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/hdf5_file.h>
#include <mpm_granular/output/points_output.h>
#include <mpm_granular/output/run_folder.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

using namespace Test;
namespace Mpi = Utilities::MPI;
namespace fs  = std::filesystem;

// Single precision has no odd numbers from here on.
constexpr std::uint32_t first_id = 1u << 24;

bool
is_first()
{
  return Mpi::this_mpi_process(MPI_COMM_WORLD) == 0;
}



void
say(const std::string &text)
{
  if (is_first())
    std::cout << text << std::endl;
}



/// Values follow from ids; the first rank has 70,000 points, the next none, the
/// others three each.
Points::PointArrays<2>
points_of_rank()
{
  const unsigned int     rank = Mpi::this_mpi_process(MPI_COMM_WORLD);
  Points::PointArrays<2> points;
  points.resize(rank == 0 ? 70000 : rank == 1 ? 0 : 3, 1);
  for (unsigned int i = 0; i < points.size(); ++i)
    {
      const std::uint32_t id = first_id + (rank == 0 ? i : 70000 + i);
      points.id[i]           = id;
      points.position[0][i]  = (id - first_id) * 0.5;
      points.position[1][i]  = (id - first_id) * -2.;
      points.velocity[1][i]  = (id - first_id) * 4.;
      points.history[0][i]   = id % 3;
    }
  return points;
}



/// Reads an array as a whole.
template <class Number>
std::vector<Number>
read(const std::string &path, const std::string &name, unsigned int &width)
{
  const Core::Hdf5File file(path, Core::Hdf5File::Mode::read, MPI_COMM_SELF);
  Core::NumberType     type;
  Core::Extent         extent = file.extent(name, type);
  extent.n_local_rows         = extent.n_rows;
  width                       = extent.width;
  if (type != Core::number_type<Number>())
    return {};
  std::vector<Number> data(extent.n_rows * extent.width);
  file.read(name, type, extent, data.data());
  return data;
}



/// Whether a row of an array is what follows from its id.
void
print_agreement(const std::string                                &path,
                const std::string                                &name,
                const unsigned int                                stride,
                const std::function<double(unsigned int number,
                                           unsigned int column)> &expected)
{
  if (!is_first())
    return;
  unsigned int               width, one;
  const auto                 values = read<float>(path, name, width);
  const auto                 ids = read<std::uint32_t>(path, "fields/id", one);
  std::vector<std::uint32_t> in_order = ids;
  std::sort(in_order.begin(), in_order.end());
  bool agrees = values.size() == ids.size() * width && !ids.empty();
  for (unsigned int i = 0; agrees && i < ids.size(); ++i)
    {
      agrees = in_order[i] % stride == 0 &&
               (i == 0 || in_order[i] - in_order[i - 1] == stride);
      for (unsigned int c = 0; agrees && c < width; ++c)
        agrees = values[i * width + c] ==
                 static_cast<float>(expected(ids[i] - first_id, c));
    }
  std::cout << "  " << name << ": " << ids.size() << " rows of " << width
            << ", " << (agrees ? "agrees" : "does not agree") << std::endl;
}



/// Prints what the group of @p pattern finds in the file before the arrays of a
/// VTU file, one a line.
void
print_matches(const std::string &path, const std::string &pattern)
{
  if (!is_first())
    return;
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string contents =
    text.str().substr(0, text.str().find("<AppendedData"));
  const std::regex wanted(pattern);
  for (std::sregex_iterator match(contents.begin(), contents.end(), wanted),
       end;
       match != end;
       ++match)
    std::cout << "  " << match->str(1) << std::endl;
}



/// Writes the points twice.
void
write(const std::string &name, const Output::OutputParameters &parameters)
{
  say(name);
  if (is_first())
    fs::remove_all(parameters.directory);
  const SimpleLaw<2>      law(1500., {"strain"});
  Output::PointsOutput<2> output(parameters, {&law}, MPI_COMM_WORLD);
  for (const double time : {0., 0.5})
    output.write(time, 10 * time, points_of_rank());
  if (!is_first())
    return;
  std::vector<std::string> files;
  for (const auto &entry : fs::recursive_directory_iterator("run"))
    if (!entry.is_directory())
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  for (const auto &file : files)
    std::cout << "  " << file << std::endl;
}



void
try_on_all(const std::string &name, const std::function<void()> &action)
{
  std::string message = "no error";
  try
    {
      Output::on_all_ranks(MPI_COMM_WORLD, action);
    }
  catch (const InputError &error)
    {
      message = std::string("input, ") + error.what();
    }
  catch (const ComputationError &error)
    {
      message = std::string("computation, ") + error.what();
    }
  const auto all = Mpi::all_gather(MPI_COMM_WORLD, message);
  say("  " + name + ": " + message + "; the same on all: " +
      (std::count(all.begin(), all.end(), message) ==
           static_cast<int>(all.size()) ?
         "yes" :
         "no"));
}



int
main(int argc, char **argv)
{
  const Mpi::MPI_InitFinalize mpi(argc, argv, 1);
  Output::OutputParameters    parameters;
  parameters.directory    = "run";
  parameters.point_fields = {"id", "velocity", "strain"};

  parameters.format = "HDF5";
  for (const std::string compression : {"none", "fast"})
    for (const unsigned int stride : {1, 3})
      {
        parameters.compression     = compression;
        parameters.every_nth_point = stride;
        write("HDF5, compression " + compression + ", every " +
                std::to_string(stride),
              parameters);
        const std::string file = "run/points/points-00001.h5";
        print_agreement(file, "position", stride, [](auto number, auto column) {
          return column == 0 ? 0.5 * number : column == 1 ? -2. * number : 0.;
        });
        print_agreement(file,
                        "fields/velocity",
                        stride,
                        [](auto number, auto column) {
                          return column == 1 ? 4. * number : 0.;
                        });
        print_agreement(file, "fields/strain", stride, [](auto number, auto) {
          return (first_id + number) % 3;
        });
      }
  print_matches("run/points.xdmf", "Time Value=\"([^\"]*)\"");
  print_matches("run/points.xdmf", "<DataItem ([^<]*)");

  parameters.every_nth_point = 1;
  parameters.format          = "PVTU";
  write("PVTU", parameters);
  parameters.ranks_per_file = 2;
  write("PVTU, two ranks a file", parameters);
  print_matches("run/points/points-00001.pvtu", "<Piece ([^>]*)/>");
  print_matches("run/points/points-00001.pvtu", "<PDataArray ([^>]*)/>");
  print_matches("run/points/points-00001-0000.vtu", "<Piece ([^>]*)>");
  print_matches("run/points.pvd", "<DataSet (timestep[^>]*)/>");

  say("Errors");
  const unsigned int last    = Mpi::n_mpi_processes(MPI_COMM_WORLD) - 1;
  const bool         is_last = Mpi::this_mpi_process(MPI_COMM_WORLD) == last;
  try_on_all("none", [] {});
  try_on_all("on the last rank", [&] {
    if (is_last)
      throw ComputationError("a full disk");
  });
  try_on_all("of the file system", [&] {
    if (is_last)
      fs::rename("no such file", "another");
  });
  try_on_all("on all ranks", [] { throw InputError("no folder"); });
}
