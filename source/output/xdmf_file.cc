#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/core/hdf5_file.h>
#include <mpm_granular/output/rows.h>
#include <mpm_granular/output/xdmf_file.h>

#include <cstdint>

namespace mpm_granular::Output
{
  using namespace dealii;

  namespace
  {
    /// Rows that are converted and written at a time.
    constexpr std::size_t max_piece_size = 65536;



    /// What XDMF calls items of a shape.
    const char *
    topology_of(const ReferenceCell shape)
    {
      return shape == ReferenceCells::Vertex ?
               R"(Polyvertex" NodesPerElement="1)" :
             shape == ReferenceCells::Triangle      ? "Triangle" :
             shape == ReferenceCells::Quadrilateral ? "Quadrilateral" :
             shape == ReferenceCells::Tetrahedron   ? "Tetrahedron" :
                                                      "Hexahedron";
    }



    /// The rows of all ranks and those of this one, of one number.
    Core::Extent
    extent_of(const std::size_t n_rows, const MPI_Comm communicator)
    {
      const auto n_of_ranks =
        Utilities::MPI::all_gather(communicator, std::uint64_t(n_rows));
      Core::Extent extent;
      extent.n_local_rows = n_rows;
      for (unsigned int rank = 0; rank < n_of_ranks.size(); ++rank)
        {
          if (rank < Utilities::MPI::this_mpi_process(communicator))
            extent.first_row += n_of_ranks[rank];
          extent.n_rows += n_of_ranks[rank];
        }
      return extent;
    }



    Core::Extent
    with_width(Core::Extent extent, const unsigned int width)
    {
      extent.width = width;
      return extent;
    }



    /// Writes an array of numbers value(row, column).
    template <class Number, class Value>
    void
    write_rows(Core::Hdf5File     &file,
               const std::string  &name,
               const Core::Extent &extent,
               const unsigned int  compression_level,
               const Value        &value)
    {
      std::vector<Number> piece;
      file.write_in_pieces(
        name,
        Core::number_type<Number>(),
        extent,
        {max_piece_size, compression_level},
        [&](const std::uint64_t first, const std::uint64_t n_rows) {
          fill_rows(piece, first, n_rows, extent.width, value);
          return piece.data();
        });
    }



    /// A reference to an array.
    std::string
    data_item(const std::string  &file,
              const std::string  &name,
              const std::uint64_t n_rows,
              const unsigned int  width,
              const bool          is_natural)
    {
      return R"(<DataItem Dimensions=")" + std::to_string(n_rows) +
             (width == 1 ? "" : " " + std::to_string(width)) +
             R"(" NumberType=")" + (is_natural ? "UInt" : "Float") +
             R"(" Precision="4" Format="HDF">)" + file + ":/" + name +
             "</DataItem>";
    }
  } // namespace



  template <int item_dim, int dim>
  void
  write_hdf5(const std::string             &path,
             const double                   time,
             const unsigned int             compression_level,
             const Contents<item_dim, dim> &contents,
             const MPI_Comm                 communicator)
  {
    const bool is_first = Utilities::MPI::this_mpi_process(communicator) == 0;
    const Core::Extent one   = extent_of(is_first ? 1 : 0, communicator);
    const Core::Extent nodes = extent_of(contents.n_nodes, communicator);
    const Core::Extent items = extent_of(contents.n_items, communicator);
    Core::write_hdf5_atomically(path, communicator, [&](Core::Hdf5File &file) {
      file.write("time", Core::NumberType::real64, one, &time);
      write_rows<float>(file,
                        "position",
                        with_width(nodes, n_directions),
                        compression_level,
                        [&](const std::size_t node, const unsigned int c) {
                          return coordinate_of(contents, node, c);
                        });
      write_rows<std::uint32_t>(
        file,
        "cells",
        with_width(items, contents.shape.n_vertices()),
        compression_level,
        [&](const std::size_t item, const unsigned int k) {
          return nodes.first_row +
                 contents.nodes(item)[place_of(contents.shape, k)];
        });
      for (const auto &field : contents.fields)
        {
          const std::string  name   = "fields/" + field.name;
          const Core::Extent extent = with_width(nodes, width_of(field));
          const auto value = [&](const std::size_t node, const unsigned int c) {
            return number_of(field, node, c);
          };
          if (field.is_natural)
            write_rows<std::uint32_t>(
              file, name, extent, compression_level, value);
          else
            write_rows<float>(file, name, extent, compression_level, value);
        }
    });
  }



  template <int item_dim, int dim>
  std::string
  xdmf_grid(const std::string             &file,
            const double                   time,
            const Contents<item_dim, dim> &contents,
            const MPI_Comm                 communicator)
  {
    const auto n_nodes = extent_of(contents.n_nodes, communicator).n_rows;
    const auto n_items = extent_of(contents.n_items, communicator).n_rows;

    std::string text = R"(<Grid GridType="Uniform"><Time Value=")" +
                       Core::exact_text(time) +
                       R"("/><Topology TopologyType=")";
    text += topology_of(contents.shape);
    text +=
      R"(" NumberOfElements=")" + std::to_string(n_items) + R"(">)" +
      data_item(file, "cells", n_items, contents.shape.n_vertices(), true) +
      "</Topology>";
    text += R"(<Geometry GeometryType="XYZ">)" +
            data_item(file, "position", n_nodes, n_directions, false) +
            "</Geometry>";
    for (const auto &field : contents.fields)
      {
        const unsigned int width = width_of(field);
        text += R"(<Attribute Name=")" + field.name + R"(" AttributeType=")" +
                (width == 1 ? "Scalar" : "Vector") + R"(" Center="Node">)" +
                data_item(file,
                          "fields/" + field.name,
                          n_nodes,
                          width,
                          field.is_natural) +
                "</Attribute>";
      }
    return text + "</Grid>";
  }



  void
  write_xdmf(std::ostream                   &out,
             const std::string              &name,
             const std::vector<std::string> &grids)
  {
    out << R"(<?xml version="1.0"?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0">
<Domain>
<Grid Name=")"
        << name << R"(" GridType="Collection" CollectionType="Temporal">
)";
    for (const auto &grid : grids)
      out << grid << "\n";
    out << "</Grid>\n</Domain>\n</Xdmf>\n";
  }



#define INSTANTIATE(item_dim, dim)                                 \
  template void        write_hdf5(const std::string &,             \
                                  const double,                    \
                                  const unsigned int,              \
                                  const Contents<item_dim, dim> &, \
                                  const MPI_Comm);                 \
  template std::string xdmf_grid(const std::string &,              \
                                 const double,                     \
                                 const Contents<item_dim, dim> &,  \
                                 const MPI_Comm);
  INSTANTIATE(0, 2)
  INSTANTIATE(0, 3)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 3)
} // namespace mpm_granular::Output
