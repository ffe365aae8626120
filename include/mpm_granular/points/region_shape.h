#ifndef mpm_granular_points_region_shape_h
#define mpm_granular_points_region_shape_h

#include <deal.II/base/point.h>

#include <mpm_granular/core/registry.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>
#include <vector>

namespace mpm_granular::Points
{
  /// The part of space that a region of points fills.
  template <int dim>
  class RegionShape : public Parameters::ParameterGroup
  {
  public:
    /// Connects the shape to the mesh. @throws InputError for unknown names.
    virtual void
    attach(const Mesh::BackgroundMesh<dim> & /*mesh*/)
    {}

    /// Whether the shape holds place @p x in cell @p cell.
    virtual bool
    contains(const dealii::Point<dim> &x, const unsigned int cell) const = 0;

    /// The box around the shape [m].
    virtual dealii::BoundingBox<dim>
    bounding_box(const Mesh::BackgroundMesh<dim> &mesh) const = 0;
  };

  template <int dim>
  using RegionShapeRegistry = Core::Registry<RegionShape<dim>>;

  /// A box with sides along the axes.
  template <int dim>
  class BoxShape : public RegionShape<dim>
  {
  public:
    BoxShape();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    bool
    contains(const dealii::Point<dim> &x,
             const unsigned int        cell) const override;

    dealii::BoundingBox<dim>
    bounding_box(const Mesh::BackgroundMesh<dim> &mesh) const override;

  private:
    dealii::Point<dim> lower;
    dealii::Point<dim> upper;
  };

  /// A disc in 2D, a ball in 3D.
  template <int dim>
  class BallShape : public RegionShape<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    contains(const dealii::Point<dim> &x,
             const unsigned int        cell) const override;

    dealii::BoundingBox<dim>
    bounding_box(const Mesh::BackgroundMesh<dim> &mesh) const override;

  private:
    dealii::Point<dim> center;
    double             radius = 1.;
  };

  /// Sets of cells of the mesh, by name or material id.
  template <int dim>
  class CellSetShape : public RegionShape<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    void
    attach(const Mesh::BackgroundMesh<dim> &mesh) override;

    bool
    contains(const dealii::Point<dim> &x,
             const unsigned int        cell) const override;

    dealii::BoundingBox<dim>
    bounding_box(const Mesh::BackgroundMesh<dim> &mesh) const override;

  private:
    std::vector<std::string> sets;
    std::vector<bool>        chosen; ///< by flat cell
  };
} // namespace mpm_granular::Points

#endif
