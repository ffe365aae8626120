#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/reference_cell.h>

#include <mpm_granular/mesh/gmsh_file.h>
#include <mpm_granular/parameters/file_name.h>

#include <fstream>
#include <sstream>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    /// Names of the physical groups, from the file's own $PhysicalNames section
    /// (deal.II passes on their numbers only).
    template <int dim>
    MeshNames
    read_physical_names(std::istream &file)
    {
      MeshNames   names;
      std::string line;
      while (std::getline(file, line) && line.rfind("$PhysicalNames", 0) != 0)
        ;
      unsigned int n_names = 0;
      file >> n_names;
      for (unsigned int i = 0; i < n_names && file; ++i)
        {
          int          group_dimension = 0;
          unsigned int tag             = 0;
          std::string  name;
          file >> group_dimension >> tag;
          std::getline(file, name);
          const auto first = name.find('"'), last = name.rfind('"');
          if (first == last)
            continue;
          name = name.substr(first + 1, last - first - 1);
          if (group_dimension == dim)
            names.regions[name] = tag;
          else if (group_dimension == dim - 1)
            names.boundaries[name] = tag;
        }
      return names;
    }
  } // namespace

  template <int dim>
  void
  GmshFile<dim>::add_parameters(ParameterHandler &prm)
  {
    MeshSource<dim>::add_parameters(prm);
    prm.add_parameter("File",
                      file_name,
                      "Mesh file of gmsh (.msh), relative to this parameter "
                      "file. Its physical groups name boundaries and sets of "
                      "cells. Lengths in m.");
  }

  template <int dim>
  void
  GmshFile<dim>::check() const
  {
    require(!file_name.empty(), "Mesh/File is empty: name a gmsh file (.msh).");
  }

  template <int dim>
  MeshNames
  GmshFile<dim>::make(Triangulation<dim> &triangulation,
                      const std::string  &input_file) const
  {
    const std::string path =
      Parameters::resolve_input_file(file_name, input_file, "Mesh/File");

    std::ifstream for_names(path);
    const auto    names = read_physical_names<dim>(for_names);

    // The reader of streams, not the one that goes through the gmsh library:
    // that one garbles meshes of OpenCASCADE geometries (deal.II 9.4).
    std::ifstream file(path);
    GridIn<dim>   reader(triangulation);
    try
      {
        reader.read_msh(file);
      }
    catch (const ExceptionBase &exception)
      {
        // The first line of deal.II's reason; lists of formats may follow it.
        std::stringstream text;
        exception.print_info(text);
        std::string reason;
        std::getline(text >> std::ws, reason);
        throw InputError("The mesh file '" + path +
                         "' cannot be read as a gmsh mesh of dimension " +
                         std::to_string(dim) + ": " + reason);
      }
    const bool wants_simplices = this->cell_kind() == CellKind::simplex;
    for (const auto &cell : triangulation.active_cell_iterators())
      require(wants_simplices ? cell->reference_cell().is_simplex() :
                                cell->reference_cell().is_hyper_cube(),
              "The mesh file '" + path + "' has cells that are not " +
                name_of_cells(this->cell_kind(), dim) +
                "; Mesh/Cells says what they should be.");
    return names;
  }

  template class GmshFile<2>;
  template class GmshFile<3>;

  namespace
  {
    const std::string documentation =
      "a mesh made by gmsh, unstructured or not.";
    const MeshSourceRegistry<2>::Entry<GmshFile<2>> gmsh_2d("gmsh file",
                                                            documentation);
    const MeshSourceRegistry<3>::Entry<GmshFile<3>> gmsh_3d("gmsh file",
                                                            documentation);
  } // namespace
} // namespace mpm_granular::Mesh
