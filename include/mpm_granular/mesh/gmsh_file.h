#ifndef mpm_granular_mesh_gmsh_file_h
#define mpm_granular_mesh_gmsh_file_h

#include <mpm_granular/mesh/mesh_source.h>

#include <string>

namespace mpm_granular::Mesh
{
  /**
   * A mesh from a gmsh file (.msh), unstructured or not.
   * Physical groups of cells become sets of cells, physical groups of faces
   * become boundaries, both by their names.
   */
  template <int dim>
  class GmshFile : public MeshSource<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    MeshNames
    make(dealii::Triangulation<dim> &triangulation,
         const std::string          &input_file) const override;

  private:
    std::string file_name;
  };
} // namespace mpm_granular::Mesh

#endif
