#ifndef mpm_granular_mesh_mesh_source_h
#define mpm_granular_mesh_mesh_source_h

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <mpm_granular/core/registry.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <map>
#include <string>

namespace mpm_granular::Mesh
{
  /// Names of the numbers that mark boundaries and sets of cells.
  struct MeshNames
  {
    std::map<std::string, unsigned int> boundaries; ///< boundary ids
    std::map<std::string, unsigned int> regions;    ///< material ids
  };

  /**
   * The number of a boundary or set of cells given by its name, or by the
   * number itself as text.
   *
   * @param kind what the names stand for, for the message.
   * @throws InputError that lists the valid names.
   */
  unsigned int
  id_by_name(const std::map<std::string, unsigned int> &ids,
             const std::string                         &name,
             const std::string                         &kind);

  /// What the cells of a mesh are; all are of one kind.
  enum class CellKind
  {
    simplex,  ///< triangles, tetrahedra
    hypercube ///< parallelograms, parallelepipeds
  };

  /// What cells of a kind are called: "triangles", say.
  std::string
  name_of_cells(const CellKind kind, const int dim);

  /// Where a mesh comes from: a box, a file.
  template <int dim>
  class MeshSource : public Parameters::ParameterGroup
  {
  public:
    /// The entries that all sources have.
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    CellKind
    cell_kind() const;

    /// Makes the cells of @p triangulation, all of cell_kind(); names of files
    /// are relative to @p input_file. @throws InputError.
    virtual MeshNames
    make(dealii::Triangulation<dim> &triangulation,
         const std::string          &input_file) const = 0;

  private:
    std::string cells = "simplices";
  };

  template <int dim>
  using MeshSourceRegistry = Core::Registry<MeshSource<dim>>;
} // namespace mpm_granular::Mesh

#endif
