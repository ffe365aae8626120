#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/mesh/mesh_source.h>

#include <algorithm>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  unsigned int
  id_by_name(const std::map<std::string, unsigned int> &ids,
             const std::string                         &name,
             const std::string                         &kind)
  {
    const auto found = ids.find(name);
    if (found != ids.end())
      return found->second;
    if (!name.empty() && std::all_of(name.begin(), name.end(), ::isdigit))
      return std::stoul(name);

    std::string valid;
    for (const auto &[valid_name, id] : ids)
      valid += (valid.empty() ? "" : ", ") + valid_name;
    throw InputError("The mesh has no " + kind + " named '" + name +
                     "'; its names are: " + valid + ".");
  }

  std::string
  name_of_cells(const CellKind kind, const int dim)
  {
    return kind == CellKind::simplex ?
             (dim == 2 ? "triangles" : "tetrahedra") :
             (dim == 2 ? "quadrilaterals" : "hexahedra");
  }

  template <int dim>
  void
  MeshSource<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Cells",
      cells,
      "Simplices (triangles, tetrahedra) with linear shape functions, of which "
      "every process holds the whole mesh; or hypercubes (quadrilaterals, "
      "hexahedra) with bi- or trilinear ones, of which p4est gives every process "
      "its part. Hypercubes must be box-like: parallelograms, parallelepipeds.",
      Patterns::Selection("simplices|hypercubes"));
  }

  template <int dim>
  CellKind
  MeshSource<dim>::cell_kind() const
  {
    return cells == "simplices" ? CellKind::simplex : CellKind::hypercube;
  }

  template class MeshSource<2>;
  template class MeshSource<3>;
} // namespace mpm_granular::Mesh
