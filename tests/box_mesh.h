#ifndef tests_box_mesh_h
#define tests_box_mesh_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/box.h>

#include <string>
#include <vector>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// A box in equal cells of a kind ("simplices", "hypercubes").
  template <int dim>
  class BoxMesh : public Mesh::Box<dim>
  {
  public:
    /// The unit box.
    BoxMesh(const std::string &cells, const unsigned int n_subdivisions)
      : BoxMesh(cells,
                std::vector<unsigned int>(dim, n_subdivisions),
                Point<dim>(),
                upper_corner())
    {}

    BoxMesh(const std::string               &cells,
            const std::vector<unsigned int> &subdivisions,
            const Point<dim>                &lower,
            const Point<dim>                &upper)
    {
      ParameterHandler prm;
      this->add_parameters(prm);
      prm.set("Cells", cells);
      prm.set("Subdivisions", Patterns::Tools::to_string(subdivisions));
      prm.set("Lower corner", Patterns::Tools::to_string(lower));
      prm.set("Upper corner", Patterns::Tools::to_string(upper));
    }

  private:
    static Point<dim>
    upper_corner()
    {
      Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = 1.;
      return corner;
    }
  };
} // namespace Test

#endif
