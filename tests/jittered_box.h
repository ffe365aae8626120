#ifndef tests_jittered_box_h
#define tests_jittered_box_h

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <mpm_granular/mesh/background_mesh.h>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// The unit box in irregular simplices: n subdivisions a side, inner vertices
  /// moved at random (but always the same way).
  template <int dim>
  class JitteredBox : public Mesh::MeshSource<dim>
  {
  public:
    explicit JitteredBox(const unsigned int n_subdivisions)
      : n_subdivisions(n_subdivisions)
    {}

    void
    add_parameters(ParameterHandler &) override
    {}

    Mesh::MeshNames
    make(Triangulation<dim> &triangulation, const std::string &) const override
    {
      Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = 1.;
      GridGenerator::subdivided_hyper_rectangle_with_simplices(
        triangulation,
        std::vector<unsigned int>(dim, n_subdivisions),
        Point<dim>(),
        corner);
      GridTools::distort_random(.2, triangulation, true, 1);
      return {};
    }

  private:
    const unsigned int n_subdivisions;
  };

  /// A number between 0 and 1 that depends on @p n in an irregular way.
  inline double
  scattered(const unsigned int n)
  {
    const double x = .6180339887498949 * (n + 1);
    return x - static_cast<unsigned int>(x);
  }
} // namespace Test

#endif
