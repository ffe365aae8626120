#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/file_series.h>
#include <mpm_granular/output/run_folder.h>
#include <mpm_granular/output/vtu_file.h>
#include <mpm_granular/output/xdmf_file.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <system_error>

namespace mpm_granular::Output
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    /// Consecutive ranks that write a file together.
    class RankGroup
    {
    public:
      RankGroup(const MPI_Comm all, const unsigned int size)
        : index(Utilities::MPI::this_mpi_process(all) / size)
      {
        const int error = MPI_Comm_split(all, index, 0, &communicator);
        AssertThrowMPI(error);
      }

      ~RankGroup()
      {
        MPI_Comm_free(&communicator);
      }

      RankGroup(const RankGroup &) = delete;
      RankGroup &
      operator=(const RankGroup &) = delete;

      const unsigned int index;
      MPI_Comm           communicator;
    };



    /// The name of the VTU file of a group of ranks beside the PVTU file @p pvtu.
    std::string
    name_of_piece(const std::string &pvtu, const unsigned int group)
    {
      return fs::path(pvtu).stem().string() + "-" +
             Utilities::int_to_string(group, 4) + ".vtu";
    }
  } // namespace



  FileSeries::FileSeries(const OutputParameters &parameters,
                         const std::string      &name,
                         const MPI_Comm          communicator)
    : parameters(parameters)
    , name(name)
    , communicator(communicator)
  {}



  template <int item_dim, int dim>
  void
  FileSeries::add(const double                   time,
                  const unsigned int             step,
                  const Contents<item_dim, dim> &contents)
  {
    on_first_rank(communicator, [&] {
      std::error_code ignored; // the file cannot be written then, either
      fs::create_directories(path(name), ignored);
    });
    const std::string file = file_name(n_files());
    if (parameters.format == "HDF5")
      {
        write_hdf5(path(file),
                   time,
                   parameters.compression_level(),
                   contents,
                   communicator);
        xdmf_grids.push_back(xdmf_grid(file, time, contents, communicator));
      }
    else
      write_vtu_files(path(file), time, step, contents);
    times_and_names.emplace_back(time, file);
    on_first_rank(communicator, [this] { write_record(); });
  }



  template <int item_dim, int dim>
  void
  FileSeries::write_vtu_files(const std::string             &file,
                              const double                   time,
                              const unsigned int             step,
                              const Contents<item_dim, dim> &contents) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const bool         in_groups = parameters.format == "PVTU";
    const unsigned int group_size =
      in_groups ? parameters.ranks_per_file : n_ranks;
    const RankGroup group(communicator, group_size);
    on_all_ranks(communicator, [&] {
      const std::string piece =
        (fs::path(file).parent_path() / name_of_piece(file, group.index))
          .string();
      write_vtu(in_groups ? piece : file,
                time,
                step,
                parameters.compression_level(),
                contents,
                group.communicator);
    });
    if (!in_groups)
      return;

    std::vector<std::string> pieces;
    for (unsigned int g = 0; g * group_size < n_ranks; ++g)
      pieces.push_back(name_of_piece(file, g));
    on_first_rank(communicator, [&] {
      write_atomically(file, [&](std::ostream &out) {
        write_pvtu(out, pieces, contents.fields);
      });
    });
  }



  void
  FileSeries::serialize(Core::Archive &archive)
  {
    std::string format = parameters.format;
    archive.replicated("output/format_of_" + name, format);
    require(format == parameters.format,
            "Output/Format cannot be changed from '" + format + "' to '" +
              parameters.format + "' when a run is continued.");

    std::vector<double> times;
    std::string         grids;
    for (const auto &record : times_and_names)
      times.push_back(record.first);
    for (const auto &grid : xdmf_grids)
      grids += grid + "\n";
    archive.replicated("output/times_of_" + name, times);
    archive.replicated("output/xdmf_of_" + name, grids);
    if (!archive.is_reading())
      return;
    times_and_names.clear();
    for (const double time : times)
      times_and_names.emplace_back(time, file_name(n_files()));
    xdmf_grids.clear();
    std::istringstream lines(grids);
    for (std::string grid; std::getline(lines, grid);)
      xdmf_grids.push_back(grid);
  }



  void
  FileSeries::resume()
  {
    const std::regex      of_series(name +
                               "-([0-9]+)(-[0-9]+)?\\.(vtu|pvtu|h5)(\\.tmp)?");
    std::vector<fs::path> too_new;
    std::error_code       ignored; // there is no folder without files
    for (const auto &entry : fs::directory_iterator(path(name), ignored))
      {
        const std::string file = entry.path().filename().string();
        std::smatch       parts;
        if (std::regex_match(file, parts, of_series) &&
            (parts[4].matched || std::stoul(parts[1]) >= n_files()))
          too_new.push_back(entry.path());
      }
    // First the record, which names complete files at any moment.
    if (n_files() > 0)
      write_record();
    else
      fs::remove(path(record_name()), ignored);
    for (const auto &file : too_new)
      fs::remove(file, ignored);
  }



  std::string
  FileSeries::path(const std::string &file) const
  {
    return (fs::path(parameters.directory) / file).string();
  }



  std::string
  FileSeries::file_name(const unsigned int index) const
  {
    return name + "/" + name + "-" + Utilities::int_to_string(index, 5) +
           (parameters.format == "HDF5" ? ".h5" :
            parameters.format == "PVTU" ? ".pvtu" :
                                          ".vtu");
  }



  std::string
  FileSeries::record_name() const
  {
    return name + (parameters.format == "HDF5" ? ".xdmf" : ".pvd");
  }



  void
  FileSeries::write_record() const
  {
    // By way of a string: deal.II throws where a stream has failed.
    std::ostringstream text;
    if (parameters.format == "HDF5")
      write_xdmf(text, name, xdmf_grids);
    else
      DataOutBase::write_pvd_record(text, times_and_names);
    write_atomically(path(record_name()),
                     [&](std::ostream &out) { out << text.str(); });
  }



  template void
  FileSeries::add(const double, const unsigned int, const Contents<0, 2> &);
  template void
  FileSeries::add(const double, const unsigned int, const Contents<0, 3> &);
  template void
  FileSeries::add(const double, const unsigned int, const Contents<2, 2> &);
  template void
  FileSeries::add(const double, const unsigned int, const Contents<3, 3> &);
} // namespace mpm_granular::Output
