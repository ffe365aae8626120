#include <boost/endian/conversion.hpp>

#include <zlib.h>

#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/output/rows.h>
#include <mpm_granular/output/run_folder.h>
#include <mpm_granular/output/vtu_file.h>

#include <array>
#include <cstdint>
#include <functional>
#include <new>
#include <type_traits>

namespace mpm_granular::Output
{
  using namespace dealii;

  namespace
  {
    /// An array of the file, on all ranks the same but for the numbers.
    struct Array
    {
      const char *section;     ///< the XML element it belongs to
      std::string description; ///< its XML attributes
      std::string unit;

      /// This rank's numbers, as they are in the file.
      std::function<std::string(const unsigned int compression_level)> bytes;
    };



    /// An array of numbers as it is in the file: a header, then the numbers.
    template <class Number>
    std::string
    bytes_of(const std::vector<Number> &numbers,
             const unsigned int         compression_level)
    {
      const char         *data = reinterpret_cast<const char *>(numbers.data());
      const std::uint64_t n_data = numbers.size() * sizeof(Number);
      // VTK's header of compressed data: the number of blocks, the size of all
      // but the last, that of the last if it is another one, and what zlib has
      // made of each.
      std::vector<std::uint64_t> header{n_data};
      std::string                compressed;
      if (compression_level > 0)
        {
          header = {0, 0, 0};
          if (n_data > 0)
            {
              uLongf n_compressed = compressBound(n_data);
              compressed.resize(n_compressed);
              const int status =
                compress2(reinterpret_cast<Bytef *>(compressed.data()),
                          &n_compressed,
                          reinterpret_cast<const Bytef *>(data),
                          n_data,
                          compression_level);
              if (status != Z_OK) // nothing else can be wrong
                throw std::bad_alloc();
              compressed.resize(n_compressed);
              header = {1, n_data, 0, n_compressed};
            }
        }
      std::string bytes(reinterpret_cast<const char *>(header.data()),
                        header.size() * sizeof(header[0]));
      if (compression_level > 0)
        bytes += compressed;
      else
        bytes.append(data, n_data);
      return bytes;
    }



    /// VTK's name of a type.
    template <class Number>
    std::string
    name_of_type()
    {
      return (std::is_floating_point_v<Number> ? "Float" :
              std::is_signed_v<Number>         ? "Int" :
                                                 "UInt") +
             std::to_string(8 * sizeof(Number));
    }



    std::string
    describe(const std::string &type,
             const std::string &name,
             const unsigned int width)
    {
      return "type=\"" + type + "\" Name=\"" + name +
             "\" NumberOfComponents=\"" + std::to_string(width) + "\"";
    }

    std::string
    description_of_positions()
    {
      return describe(name_of_type<float>(), "Points", n_directions);
    }

    std::string
    description_of(const Field &field)
    {
      return describe(field.is_natural ? name_of_type<std::uint32_t>() :
                                         name_of_type<float>(),
                      field.name,
                      width_of(field));
    }



    /// What gives the bytes of an array of numbers value(row, column).
    template <class Number, class Value>
    auto
    bytes_of_rows(const std::size_t  n_rows,
                  const unsigned int width,
                  const Value       &value)
    {
      return [n_rows, width, value](const unsigned int compression_level) {
        std::vector<Number> rows;
        fill_rows(rows, 0, n_rows, width, value);
        return bytes_of(rows, compression_level);
      };
    }



    /// All arrays, in the order of the file. They look at @p contents.
    template <int item_dim, int dim>
    std::vector<Array>
    arrays_of(const Contents<item_dim, dim> &contents)
    {
      const auto         shape      = contents.shape;
      const unsigned int n_vertices = shape.n_vertices();
      std::vector<Array> arrays{
        {"Points",
         description_of_positions(),
         "",
         bytes_of_rows<float>(contents.n_nodes,
                              n_directions,
                              [&](const auto node, const auto c) {
                                return coordinate_of(contents, node, c);
                              })},
        {"Cells",
         describe(name_of_type<std::int32_t>(), "connectivity", 1),
         "",
         bytes_of_rows<std::int32_t>(contents.n_items,
                                     n_vertices,
                                     [&, shape](const auto item, const auto k) {
                                       return contents.nodes(
                                         item)[place_of(shape, k)];
                                     })},
        {"Cells",
         describe(name_of_type<std::int32_t>(), "offsets", 1),
         "",
         bytes_of_rows<std::int32_t>(contents.n_items,
                                     1,
                                     [=](const auto item, const auto) {
                                       return (item + 1) * n_vertices;
                                     })},
        {"Cells",
         describe(name_of_type<std::uint8_t>(), "types", 1),
         "",
         bytes_of_rows<std::uint8_t>(contents.n_items,
                                     1,
                                     [=](const auto, const auto) {
                                       return shape.vtk_linear_type();
                                     })}};
      for (const auto &field : contents.fields)
        {
          const auto value = [&field](const auto node, const auto c) {
            return number_of(field, node, c);
          };
          const unsigned int width = width_of(field);
          Array array{"PointData", description_of(field), field.unit, {}};
          if (field.is_natural)
            array.bytes =
              bytes_of_rows<std::uint32_t>(contents.n_nodes, width, value);
          else
            array.bytes = bytes_of_rows<float>(contents.n_nodes, width, value);
          arrays.push_back(std::move(array));
        }
      return arrays;
    }



    /// What a rank has in the file.
    struct Piece
    {
      unsigned int               rank;
      std::uint64_t              n_nodes, n_items;
      std::vector<std::uint64_t> offsets; ///< where each array begins [bytes]
    };



    /// All ranks with items, on the first rank; if there are none, itself, as
    /// there must be a piece.
    template <int item_dim, int dim>
    std::vector<Piece>
    pieces_of(const Contents<item_dim, dim> &contents,
              const std::size_t              n_arrays,
              const MPI_Comm                 communicator)
    {
      const auto sizes =
        Utilities::MPI::gather(communicator,
                               std::array<std::uint64_t, 2>{
                                 {contents.n_nodes, contents.n_items}});
      std::vector<Piece> pieces;
      const auto         add = [&](const unsigned int rank) {
        pieces.push_back({rank,
                          sizes[rank][0],
                          sizes[rank][1],
                          std::vector<std::uint64_t>(n_arrays, 0)});
      };
      for (unsigned int rank = 0; rank < sizes.size(); ++rank)
        if (sizes[rank][1] > 0)
          add(rank);
      if (pieces.empty() && !sizes.empty())
        add(0);
      return pieces;
    }



    /// An attribute that is as long for any number.
    std::string
    offset_attribute(const std::uint64_t offset)
    {
      std::string text = " offset=\"" + std::to_string(offset) + "\"";
      text.resize(30, ' ');
      return text;
    }



    /// The XML before the arrays, as long for any offsets.
    std::string
    head(const double              time,
         const unsigned int        step,
         const bool                is_compressed,
         const std::vector<Array> &arrays,
         const std::vector<Piece> &pieces)
    {
      std::string text =
        R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order=")";
      text += boost::endian::order::native == boost::endian::order::little ?
                "LittleEndian" :
                "BigEndian";
      text += R"(" header_type="UInt64")";
      if (is_compressed)
        text += R"( compressor="vtkZLibDataCompressor")";
      text += R"(>
<UnstructuredGrid>
<FieldData>
<DataArray type="Int32" Name="CYCLE" NumberOfTuples="1" format="ascii">)" +
              std::to_string(step) + R"(</DataArray>
<DataArray type="Float64" Name="TIME" NumberOfTuples="1" format="ascii">)" +
              Core::exact_text(time) + R"(</DataArray>
</FieldData>
)";
      for (const auto &piece : pieces)
        {
          text += R"(<Piece NumberOfPoints=")" + std::to_string(piece.n_nodes) +
                  R"(" NumberOfCells=")" + std::to_string(piece.n_items) +
                  "\">\n";
          for (const std::string section : {"Points", "Cells", "PointData"})
            {
              text += "<" + section + ">\n";
              for (std::size_t a = 0; a < arrays.size(); ++a)
                if (arrays[a].section == section)
                  {
                    text += "<DataArray " + arrays[a].description +
                            R"( format="appended")" +
                            offset_attribute(piece.offsets[a]);
                    if (arrays[a].unit.empty())
                      text += "/>\n";
                    else
                      text +=
                        R"(>
<InformationKey name="UNITS_LABEL" location="vtkDataArray">)" +
                        arrays[a].unit + "</InformationKey>\n</DataArray>\n";
                  }
              text += "</" + section + ">\n";
            }
          text += "</Piece>\n";
        }
      return text + "</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    }

    constexpr char tail[] = "\n</AppendedData>\n</VTKFile>\n";



    constexpr int tag = 7412;

    void
    send_to_first(const std::string &bytes, const MPI_Comm communicator)
    {
      const int error =
        MPI_Send(bytes.data(), bytes.size(), MPI_CHAR, 0, tag, communicator);
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
      std::string bytes(n_bytes, '\0');
      error = MPI_Recv(bytes.data(),
                       n_bytes,
                       MPI_CHAR,
                       rank,
                       tag,
                       communicator,
                       MPI_STATUS_IGNORE);
      AssertThrowMPI(error);
      return bytes;
    }



    /// Writes the file to @p out of the first rank; the others only send.
    template <int item_dim, int dim>
    void
    write_to(std::ostream                  &out,
             const double                   time,
             const unsigned int             step,
             const unsigned int             compression_level,
             const Contents<item_dim, dim> &contents,
             const MPI_Comm                 communicator)
    {
      const auto arrays = arrays_of(contents);
      auto       pieces = pieces_of(contents, arrays.size(), communicator);
      if (Utilities::MPI::this_mpi_process(communicator) > 0)
        {
          if (contents.n_items > 0)
            for (const auto &array : arrays)
              send_to_first(array.bytes(compression_level), communicator);
          return;
        }

      const auto write_head = [&] {
        out << head(time, step, compression_level > 0, arrays, pieces);
      };
      write_head();
      std::uint64_t offset = 0;
      for (std::size_t a = 0; a < arrays.size(); ++a)
        for (auto &piece : pieces)
          {
            const std::string bytes = piece.rank == 0 ?
                                        arrays[a].bytes(compression_level) :
                                        receive_from(piece.rank, communicator);
            out << bytes;
            piece.offsets[a] = offset;
            offset += bytes.size();
          }
      out << tail;
      // Once more, now that the offsets are known.
      out.seekp(0);
      write_head();
    }
  } // namespace



  template <int item_dim, int dim>
  void
  write_vtu(const std::string             &path,
            const double                   time,
            const unsigned int             step,
            const unsigned int             compression_level,
            const Contents<item_dim, dim> &contents,
            const MPI_Comm                 communicator)
  {
    const auto write = [&](std::ostream &out) {
      write_to(out, time, step, compression_level, contents, communicator);
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
             const std::vector<std::string> &files,
             const std::vector<Field>       &fields)
  {
    out << R"(<?xml version="1.0"?>
<VTKFile type="PUnstructuredGrid" version="1.0">
<PUnstructuredGrid GhostLevel="0">
<PPoints>
<PDataArray )"
        << description_of_positions() << R"(/>
</PPoints>
<PPointData>
)";
    for (const auto &field : fields)
      out << "<PDataArray " << description_of(field) << "/>\n";
    out << "</PPointData>\n";
    for (const auto &file : files)
      out << "<Piece Source=\"" << file << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }



#define INSTANTIATE(item_dim, dim)                         \
  template void write_vtu(const std::string &,             \
                          const double,                    \
                          const unsigned int,              \
                          const unsigned int,              \
                          const Contents<item_dim, dim> &, \
                          const MPI_Comm);
  INSTANTIATE(0, 2)
  INSTANTIATE(0, 3)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 3)
} // namespace mpm_granular::Output
