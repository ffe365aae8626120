#include <deal.II/base/hdf5.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/full_matrix.h>

#include <mpm_granular/parameters/file_name.h>
#include <mpm_granular/points/point_file.h>

#include <fstream>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Rows of dim coordinates and a volume.
    using Table = std::vector<std::vector<double>>;

    Table
    read_csv(const std::string &path, const unsigned int dim)
    {
      const std::string header = dim == 2 ? "x,y,volume" : "x,y,z,volume";
      std::ifstream     file(path);
      std::string       line;
      std::getline(file, line);
      line.erase(std::remove_if(line.begin(), line.end(), ::isspace),
                 line.end());
      require(line == header,
              path + ", line 1: the header must be '" + header + "', not '" +
                line + "'.");

      Table table;
      for (unsigned int number = 2; std::getline(file, line); ++number)
        {
          if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
          try
            {
              table.push_back(Utilities::string_to_double(
                Utilities::split_string_list(line)));
            }
          catch (const ExceptionBase &)
            {
              table.emplace_back();
            }
          require(table.back().size() == dim + 1,
                  path + ", line " + std::to_string(number) + ": expected " +
                    std::to_string(dim + 1) + " numbers (" + header +
                    "), given '" + line + "'.");
        }
      return table;
    }

    Table
    read_hdf5(const std::string &path, const unsigned int dim)
    {
      try
        {
          HDF5::File file(path, HDF5::File::FileAccessMode::open);
          const auto volumes =
            file.open_dataset("volume").read<std::vector<double>>();
          const auto positions =
            file.open_dataset("position").read<FullMatrix<double>>();
          require(positions.m() == volumes.size() && positions.n() == dim,
                  path +
                    ": 'position' must have as many rows as 'volume' and " +
                    std::to_string(dim) + " columns.");
          Table table;
          for (unsigned int row = 0; row < volumes.size(); ++row)
            {
              table.emplace_back();
              for (unsigned int d = 0; d < dim; ++d)
                table.back().push_back(positions(row, d));
              table.back().push_back(volumes[row]);
            }
          return table;
        }
      catch (const ExceptionBase &)
        {
          throw InputError(path + " is not an HDF5 file with the data sets "
                                  "'position' and 'volume' of doubles.");
        }
    }
  } // namespace

  template <int dim>
  void
  PointFile<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "File",
      file_name,
      "File of points, relative to this parameter file: CSV with "
      "the header x,y,volume (2D) or x,y,z,volume (3D), or HDF5 "
      "(name ends in .h5) with the data sets 'position' and "
      "'volume'. Units: m and m^3, in 2D m^2.");
  }

  template <int dim>
  void
  PointFile<dim>::check() const
  {
    require(!file_name.empty(),
            "A region of layout 'file' needs the name of a file of points in "
            "'File'.");
  }

  template <int dim>
  std::vector<Seed<dim>>
  PointFile<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                        const RegionShape<dim>          &shape,
                        const std::string               &input_file) const
  {
    const std::string path =
      Parameters::resolve_input_file(file_name, input_file, "File of a region");
    const bool is_hdf5 =
      path.size() > 3 && path.compare(path.size() - 3, 3, ".h5") == 0;
    const Table table = is_hdf5 ? read_hdf5(path, dim) : read_csv(path, dim);

    std::vector<Point<dim>> places(table.size());
    for (unsigned int row = 0; row < table.size(); ++row)
      for (unsigned int d = 0; d < dim; ++d)
        places[row][d] = table[row][d];

    const auto             cells = mesh.locate(places);
    std::vector<Seed<dim>> seeds;
    for (unsigned int row = 0; row < table.size(); ++row)
      {
        const double volume = table[row][dim];
        if (cells[row] == Mesh::no_cell || !(volume > 0.))
          throw InputError(path + ": point " + std::to_string(row + 1) +
                           " at " + Mesh::as_text(places[row]) +
                           (cells[row] == Mesh::no_cell ?
                              " lies outside the mesh." :
                              " has the volume " + std::to_string(volume) +
                                "; it must be positive."));
        if (cells[row] != Mesh::unknown_cell &&
            shape.contains(places[row], cells[row]))
          seeds.push_back({places[row], cells[row], volume, row});
      }
    return seeds;
  }

  template class PointFile<2>;
  template class PointFile<3>;

  namespace
  {
    const std::string documentation =
      "positions and volumes from a file (CSV, HDF5).";
    const PointLayoutRegistry<2>::Entry<PointFile<2>> file_2d("file",
                                                              documentation);
    const PointLayoutRegistry<3>::Entry<PointFile<3>> file_3d("file",
                                                              documentation);
  } // namespace
} // namespace mpm_granular::Points
