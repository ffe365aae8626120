#include <mpm_granular/checkpoint/checkpoint_file.h>
#include <mpm_granular/checkpoint/checksum.h>
#include <mpm_granular/core/exceptions.h>

#include <cstring>
#include <sstream>

namespace mpm_granular::Checkpoint
{
  namespace MPI = dealii::Utilities::MPI;
  using Core::NumberType;

  Reader::Reader(const std::string &path, const MPI_Comm comm)
    : file_name(path)
    , comm(comm)
  {
    try
      {
        file               = std::make_unique<Core::Hdf5File>(path,
                                                Core::Hdf5File::Mode::read,
                                                comm);
        const auto version = file->read_attribute("/", "format_version");
        if (version > format_version)
          refuse("a newer version of this program wrote it (format " +
                 std::to_string(version) + ", this one reads up to " +
                 std::to_string(format_version) + ")");
        n_ranks_then = file->read_attribute("/", "n_ranks");
        verify();
      }
    catch (const Core::Hdf5Error &error)
      {
        refuse(error.what());
      }
  }



  bool
  Reader::has_same_ranks() const
  {
    return n_ranks_then == MPI::n_mpi_processes(comm);
  }



  void
  Reader::verify()
  {
    std::string contents;
    replicated("contents", contents);
    std::istringstream names("contents\n" + contents);
    for (std::string name; std::getline(names, name);)
      {
        NumberType   type;
        Core::Extent extent = file->extent(name, type);
        // Equal parts: who reads what does not matter for a checksum.
        const std::uint64_t n_ranks = MPI::n_mpi_processes(comm);
        const std::uint64_t rank    = MPI::this_mpi_process(comm);
        extent.first_row            = extent.n_rows * rank / n_ranks;
        extent.n_local_rows =
          extent.n_rows * (rank + 1) / n_ranks - extent.first_row;
        std::vector<char> data(extent.n_local_rows * extent.width *
                               Core::size_of(type));
        file->read(name, type, extent, data.data());
        if (checksum(type, extent, data.data(), comm) !=
            file->read_attribute(name, "checksum"))
          refuse("the data of '" + name + "' do not have their checksum");
      }
  }



  void
  Reader::replicate(const std::string &name, const Numbers &numbers)
  {
    try
      {
        NumberType   type;
        Core::Extent extent = file->extent(name, type);
        extent.n_local_rows = extent.n_rows;
        if (type != numbers.type)
          refuse("'" + name + "' is of another type");

        std::vector<char> data(extent.n_rows * extent.width *
                               Core::size_of(type));
        file->read(name, type, extent, data.data());
        if (type == NumberType::character) // padded to the length of the type
          while (!data.empty() && data.back() == '\0')
            data.pop_back();
        const std::size_t n_numbers = data.size() / Core::size_of(type);
        if (numbers.is_single && n_numbers != 1)
          refuse("'" + name + "' has another size");
        void *target = numbers.resize(n_numbers);
        if (!data.empty())
          std::memcpy(target, data.data(), data.size());
      }
    catch (const Core::Hdf5Error &error)
      {
        refuse(error.what());
      }
  }



  void
  Reader::distribute(const std::string &name,
                     const Numbers     &numbers,
                     const unsigned int width)
  {
    try
      {
        NumberType   type;
        Core::Extent extent = file->extent(name, type);
        if (type != numbers.type || extent.width != width)
          refuse("'" + name + "' is of another type");
        choose_rows(name.substr(0, name.find('/')), extent);
        file->read(name,
                   type,
                   extent,
                   numbers.resize(extent.n_local_rows * width));
      }
    catch (const Core::Hdf5Error &error)
      {
        refuse(error.what());
      }
  }



  void
  Reader::choose_rows(const std::string &group, Core::Extent &extent)
  {
    const std::uint64_t n_ranks = MPI::n_mpi_processes(comm);
    const std::uint64_t rank    = MPI::this_mpi_process(comm);
    auto               &first   = offsets[group];
    if (first.empty())
      {
        replicated(group + "/offsets", first);
        if (!has_same_ranks())
          {
            const std::uint64_t n_rows = first.empty() ? 0 : first.back();
            first.clear();
            for (std::uint64_t r = 0; r <= n_ranks; ++r)
              first.push_back(n_rows * r / n_ranks);
          }
      }
    if (first.size() != n_ranks + 1 || first.back() != extent.n_rows)
      refuse("the arrays of '" + group + "' do not fit together");
    extent.first_row    = first[rank];
    extent.n_local_rows = first[rank + 1] - first[rank];
  }



  void
  Reader::refuse(const std::string &reason) const
  {
    throw InputError("The checkpoint '" + file_name +
                     "' cannot be used: " + reason + ".");
  }
} // namespace mpm_granular::Checkpoint
