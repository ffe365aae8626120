#include <mpm_granular/checkpoint/checkpoint_file.h>
#include <mpm_granular/checkpoint/checksum.h>

#include <algorithm>
#include <map>

namespace mpm_granular::Checkpoint
{
  namespace MPI = dealii::Utilities::MPI;
  using Core::Extent;

  namespace
  {
    /// A checkpoint file that is written.
    class Writer : public Core::Archive
    {
    public:
      Writer(Core::Hdf5File &file, const MPI_Comm comm)
        : comm(comm)
        , file(file)
      {
        file.write_attribute("/", "format_version", format_version);
        file.write_attribute("/", "n_ranks", MPI::n_mpi_processes(comm));
      }

      bool
      is_reading() const override
      {
        return false;
      }

      bool
      has_same_ranks() const override
      {
        return true;
      }

      /// Writes the list of what is in the file.
      void
      finish()
      {
        std::string names = contents;
        replicated("contents", names);
      }

    private:
      void
      replicate(const std::string &name, const Numbers &numbers) override
      {
        // The first process has it all.
        const bool is_text = numbers.type == Core::NumberType::character;
        Extent     extent;
        extent.n_rows = is_text ? 1 : numbers.size;
        extent.width  = is_text ? std::max<std::size_t>(numbers.size, 1) : 1;
        extent.n_local_rows =
          MPI::this_mpi_process(comm) == 0 ? extent.n_rows : 0;
        write(name, numbers.type, extent, numbers.size > 0 ? numbers.data : "");
      }

      void
      distribute(const std::string &name,
                 const Numbers     &numbers,
                 const unsigned int width) override
      {
        const std::string   group    = name.substr(0, name.find('/'));
        auto               &of_group = offsets[group];
        const std::uint64_t n_rows   = numbers.size / width;
        if (of_group.empty())
          {
            of_group = {0};
            for (const auto n : MPI::all_gather(comm, n_rows))
              of_group.push_back(of_group.back() + n);
            replicated(group + "/offsets", of_group);
          }
        const unsigned int rank = MPI::this_mpi_process(comm);
        Assert(of_group[rank + 1] - of_group[rank] == n_rows,
               dealii::ExcMessage("Arrays of a group differ in their rows."));
        write(name,
              numbers.type,
              {of_group.back(), of_group[rank], n_rows, width},
              numbers.data);
      }

      void
      write(const std::string     &name,
            const Core::NumberType type,
            const Extent          &extent,
            const void            *data)
      {
        file.write(name, type, extent, data);
        file.write_attribute(name,
                             "checksum",
                             checksum(type, extent, data, comm));
        contents += name + "\n";
      }

      const MPI_Comm                                    comm;
      Core::Hdf5File                                   &file;
      std::string                                       contents; ///< names
      std::map<std::string, std::vector<std::uint64_t>> offsets;  ///< by group
    };
  } // namespace



  void
  write(const std::string                          &path,
        const MPI_Comm                              comm,
        const std::function<void(Core::Archive &)> &serialize)
  {
    Core::write_hdf5_atomically(path, comm, [&](Core::Hdf5File &file) {
      Writer writer(file, comm);
      serialize(writer);
      writer.finish();
    });
  }
} // namespace mpm_granular::Checkpoint
