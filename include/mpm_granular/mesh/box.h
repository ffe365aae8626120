#ifndef mpm_granular_mesh_box_h
#define mpm_granular_mesh_box_h

#include <deal.II/base/point.h>

#include <mpm_granular/mesh/mesh_source.h>

#include <vector>

namespace mpm_granular::Mesh
{
  /**
   * A box of equal cells: a hypercube, 2 triangles or 5 tetrahedra per
   * subdivision. Its boundaries are named x_min, x_max, y_min, ...
   */
  template <int dim>
  class Box : public MeshSource<dim>
  {
  public:
    Box();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    MeshNames
    make(dealii::Triangulation<dim> &triangulation,
         const std::string          &input_file) const override;

  private:
    void
    mark_boundaries(dealii::Triangulation<dim> &triangulation) const;

    dealii::Point<dim>        lower;
    dealii::Point<dim>        upper;
    std::vector<unsigned int> subdivisions;
  };
} // namespace mpm_granular::Mesh

#endif
