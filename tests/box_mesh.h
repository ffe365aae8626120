#ifndef tests_box_mesh_h
#define tests_box_mesh_h

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/box.h>

#include <string>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// The unit box in equal cells of a kind ("simplices", "hypercubes").
  template <int dim>
  class BoxMesh : public Mesh::Box<dim>
  {
  public:
    BoxMesh(const std::string &cells, const unsigned int n_subdivisions)
    {
      ParameterHandler prm;
      this->add_parameters(prm);
      prm.set("Cells", cells);
      std::string subdivisions;
      for (unsigned int d = 0; d < dim; ++d)
        subdivisions += (d > 0 ? "," : "") + std::to_string(n_subdivisions);
      prm.set("Subdivisions", subdivisions);
    }
  };
} // namespace Test

#endif
