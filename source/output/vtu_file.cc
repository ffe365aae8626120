#include <deal.II/base/utilities.h>
#include <deal.II/grid/reference_cell.h>

#include <mpm_granular/output/run_folder.h>
#include <mpm_granular/output/vtu_file.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <tuple>

namespace mpm_granular::Output
{
  using namespace dealii;

  namespace
  {
    using VectorRange =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    /// The rows of a patch's data table, as deal.II wants them described.
    struct Rows
    {
      explicit Rows(const std::vector<Field> &fields)
      {
        for (const auto &field : fields)
          {
            const unsigned int first = names.size();
            for (unsigned int c = 0; c < field.n_components; ++c)
              names.push_back(field.name);
            if (field.n_components > 1)
              vectors.emplace_back(
                first,
                first + field.n_components - 1,
                field.name,
                DataComponentInterpretation::component_is_part_of_vector);
          }
      }

      std::vector<std::string> names;
      std::vector<VectorRange> vectors;
    };



    /// Fills @p patch with item @p item.
    template <int item_dim, int dim>
    void
    fill(DataOutBase::Patch<item_dim, dim> &patch,
         const Contents<item_dim, dim>     &contents,
         const std::size_t                  item)
    {
      const auto nodes = contents.nodes(item);
      for (unsigned int v = 0; v < nodes.size(); ++v)
        {
          const Point<dim> position = contents.position(nodes[v]);
          patch.vertices[v]         = position;
          unsigned int row          = 0;
          for (const auto &field : contents.fields)
            for (unsigned int c = 0; c < field.n_components; ++c)
              patch.data(row++, v) =
                static_cast<float>(field.value(nodes[v], c));
          // Items other than points and boxes carry their positions here, too.
          if constexpr (item_dim > 0)
            for (unsigned int d = 0; d < dim; ++d)
              patch.data(row++, v) = static_cast<float>(position[d]);
        }
    }



    template <int item_dim, int dim>
    std::vector<DataOutBase::Patch<item_dim, dim>>
    make_patches(const std::size_t   n_patches,
                 const unsigned int  n_rows,
                 const ReferenceCell shape)
    {
      std::vector<DataOutBase::Patch<item_dim, dim>> patches(n_patches);
      for (std::size_t i = 0; i < n_patches; ++i)
        {
          auto &patch       = patches[i];
          patch.patch_index = i;
          if constexpr (item_dim > 0)
            {
              patch.reference_cell       = shape;
              patch.n_subdivisions       = 1;
              patch.points_are_available = true;
              patch.data.reinit(n_rows + dim, shape.n_vertices());
            }
          else
            patch.data.reinit(n_rows, 1);
        }
      return patches;
    }
  } // namespace



  namespace
  {
    /// Calls @p use(text) for the text of each piece of @p contents; for one
    /// without items, if there are none and @p at_least_one.
    template <int item_dim, int dim, class Use>
    void
    for_each_piece(const Contents<item_dim, dim> &contents,
                   DataOutBase::VtkFlags          flags,
                   const bool                     at_least_one,
                   Use                          &&use)
    {
      const Rows rows(contents.fields);
      auto       patches =
        make_patches<item_dim, dim>(std::min(contents.n_items, max_piece_size),
                                    rows.names.size(),
                                    contents.shape);
      for (std::size_t n_written = 0;
           n_written < contents.n_items || (n_written == 0 && at_least_one);)
        {
          const std::size_t n_now =
            std::min(contents.n_items - n_written, max_piece_size);
          patches.resize(n_now);
          for (std::size_t i = 0; i < n_now; ++i)
            fill(patches[i], contents, n_written + i);
          std::ostringstream text;
          DataOutBase::write_vtu_main(
            patches, rows.names, rows.vectors, flags, text);
          use(text.str());
          if (n_now == 0)
            return;
          n_written += n_now;
          // Time and step belong to the file, not to each piece.
          flags.time  = std::numeric_limits<double>::min();
          flags.cycle = std::numeric_limits<unsigned int>::min();
        }
    }

    constexpr int tag = 7412;

    /// Sends a piece to the first rank; an empty text ends them.
    void
    send_to_first(const std::string &text, const MPI_Comm communicator)
    {
      const int error =
        MPI_Send(text.data(), text.size(), MPI_CHAR, 0, tag, communicator);
      AssertThrowMPI(error);
    }

    std::string
    receive_from(const unsigned int rank, const MPI_Comm communicator)
    {
      MPI_Status status;
      int        n_bytes = 0;
      int        error   = MPI_Probe(rank, tag, communicator, &status);
      AssertThrowMPI(error);
      error = MPI_Get_count(&status, MPI_CHAR, &n_bytes);
      AssertThrowMPI(error);
      std::string text(n_bytes, '\0');
      error = MPI_Recv(text.data(),
                       n_bytes,
                       MPI_CHAR,
                       rank,
                       tag,
                       communicator,
                       MPI_STATUS_IGNORE);
      AssertThrowMPI(error);
      return text;
    }



    /// Writes the file to @p out of the first rank; the others only send.
    template <int item_dim, int dim>
    void
    write_to(std::ostream                  &out,
             const DataOutBase::VtkFlags   &flags,
             const Contents<item_dim, dim> &contents,
             const MPI_Comm                 communicator)
    {
      DataOutBase::VtkFlags piece_flags = flags;
      for (const auto &field : contents.fields)
        if (!field.unit.empty())
          piece_flags.physical_units[field.name] = field.unit;

      if (Utilities::MPI::this_mpi_process(communicator) > 0)
        {
          piece_flags.time  = std::numeric_limits<double>::min();
          piece_flags.cycle = std::numeric_limits<unsigned int>::min();
          for_each_piece(contents, piece_flags, false, [&](const auto &text) {
            send_to_first(text, communicator);
          });
          send_to_first("", communicator);
          return;
        }

      // By way of strings: deal.II throws where a stream has failed, and this
      // rank must listen to the others all the same.
      std::ostringstream frame;
      DataOutBase::write_vtu_header(frame, piece_flags);
      out << frame.str();
      for_each_piece(contents, piece_flags, true, [&](const auto &text) {
        out << text;
      });
      for (unsigned int rank = 1;
           rank < Utilities::MPI::n_mpi_processes(communicator);
           ++rank)
        for (std::string text;
             !(text = receive_from(rank, communicator)).empty();)
          out << text;
      frame.str("");
      DataOutBase::write_vtu_footer(frame);
      out << frame.str();
    }
  } // namespace



  template <int item_dim, int dim>
  void
  write_vtu(const std::string             &path,
            const DataOutBase::VtkFlags   &flags,
            const Contents<item_dim, dim> &contents,
            const MPI_Comm                 communicator)
  {
    const auto write = [&](std::ostream &out) {
      write_to(out, flags, contents, communicator);
    };
    std::ostream nowhere(nullptr);
    if (Utilities::MPI::this_mpi_process(communicator) > 0)
      {
        write(nowhere);
        return;
      }
    bool is_written = false;
    try
      {
        write_atomically(path, [&](std::ostream &out) {
          is_written = true;
          write(out);
        });
      }
    catch (...)
      {
        // What the others send has to be received even if there is no file.
        if (!is_written)
          write(nowhere);
        throw;
      }
  }



  void
  write_pvtu(std::ostream                   &out,
             const DataOutBase::VtkFlags    &flags,
             const std::vector<std::string> &files,
             const std::vector<Field>       &fields)
  {
    const Rows         rows(fields);
    std::ostringstream text;
    DataOutBase::write_pvtu_record(
      text, files, rows.names, rows.vectors, flags);
    out << text.str();
  }



  template void
  write_vtu(const std::string &,
            const DataOutBase::VtkFlags &,
            const Contents<0, 2> &,
            const MPI_Comm);
  template void
  write_vtu(const std::string &,
            const DataOutBase::VtkFlags &,
            const Contents<0, 3> &,
            const MPI_Comm);
  template void
  write_vtu(const std::string &,
            const DataOutBase::VtkFlags &,
            const Contents<2, 2> &,
            const MPI_Comm);
  template void
  write_vtu(const std::string &,
            const DataOutBase::VtkFlags &,
            const Contents<3, 3> &,
            const MPI_Comm);
} // namespace mpm_granular::Output
