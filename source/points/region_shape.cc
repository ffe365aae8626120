#include <deal.II/base/mpi.h>

#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/points/region_shape.h>

#include <algorithm>
#include <limits>
#include <map>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  BoxShape<dim>::BoxShape()
  {
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1.;
  }

  template <int dim>
  void
  BoxShape<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Lower corner",
                      lower,
                      "Corner with the smallest coordinates. Units: m.");
    prm.add_parameter("Upper corner",
                      upper,
                      "Corner with the largest coordinates. Units: m.");
  }

  template <int dim>
  void
  BoxShape<dim>::check() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      require(lower[d] < upper[d],
              "The box of a region is empty: its upper corner must lie above "
              "its lower corner in every direction; in direction " +
                std::to_string(d) + " they are " + std::to_string(upper[d]) +
                " and " + std::to_string(lower[d]) + ".");
  }

  template <int dim>
  bool
  BoxShape<dim>::contains(const Point<dim> &x,
                          const unsigned int /*cell*/) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (x[d] < lower[d] || x[d] >= upper[d])
        return false;
    return true;
  }

  template <int dim>
  BoundingBox<dim>
  BoxShape<dim>::bounding_box(const Mesh::BackgroundMesh<dim> &) const
  {
    return {std::make_pair(lower, upper)};
  }

  template <int dim>
  void
  BallShape<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Center", center, "Center. Units: m.");
    prm.add_parameter("Radius",
                      radius,
                      "Radius. Units: m.",
                      Parameters::positive_number());
  }

  template <int dim>
  bool
  BallShape<dim>::contains(const Point<dim> &x,
                           const unsigned int /*cell*/) const
  {
    return x.distance_square(center) < radius * radius;
  }

  template <int dim>
  BoundingBox<dim>
  BallShape<dim>::bounding_box(const Mesh::BackgroundMesh<dim> &) const
  {
    Tensor<1, dim> reach;
    for (unsigned int d = 0; d < dim; ++d)
      reach[d] = radius;
    return {std::make_pair(center - reach, center + reach)};
  }

  template <int dim>
  void
  CellSetShape<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Cell sets",
      sets,
      "Sets of cells of the mesh that the region fills, by their "
      "names in the mesh file or their material ids.");
  }

  template <int dim>
  void
  CellSetShape<dim>::check() const
  {
    require(
      !sets.empty(),
      "A region of shape 'cells' needs at least one name in 'Cell sets'.");
  }

  template <int dim>
  void
  CellSetShape<dim>::attach(const Mesh::BackgroundMesh<dim> &mesh)
  {
    std::map<types::material_id, std::string> wanted_ids;
    for (const auto &set : sets)
      wanted_ids[Mesh::id_by_name(mesh.region_names(), set, "set of cells")] =
        set;

    chosen.assign(mesh.n_cells(), false);
    std::map<types::material_id, unsigned int> n_found;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      {
        const auto id = mesh.cell_iterator(cell)->material_id();
        chosen[cell]  = wanted_ids.count(id) > 0;
        if (chosen[cell])
          ++n_found[id];
      }
    for (const auto &[id, name] : wanted_ids)
      {
        if (mesh.is_distributed())
          n_found[id] =
            Utilities::MPI::max(n_found[id], mesh.mpi_communicator());
        require(n_found[id] > 0, "The set of cells '" + name + "' is empty.");
      }
  }

  template <int dim>
  bool
  CellSetShape<dim>::contains(const Point<dim> & /*x*/,
                              const unsigned int cell) const
  {
    return chosen[cell];
  }

  template <int dim>
  BoundingBox<dim>
  CellSetShape<dim>::bounding_box(const Mesh::BackgroundMesh<dim> &mesh) const
  {
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = std::numeric_limits<double>::max();
        upper[d] = std::numeric_limits<double>::lowest();
        for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
          if (chosen[cell])
            for (const unsigned int node : mesh.nodes(cell))
              {
                lower[d] = std::min(lower[d], mesh.node_position(node)[d]);
                upper[d] = std::max(upper[d], mesh.node_position(node)[d]);
              }
        if (mesh.is_distributed())
          {
            lower[d] = Utilities::MPI::min(lower[d], mesh.mpi_communicator());
            upper[d] = Utilities::MPI::max(upper[d], mesh.mpi_communicator());
          }
      }
    return {std::make_pair(lower, upper)};
  }

  template class BoxShape<2>;
  template class BoxShape<3>;
  template class BallShape<2>;
  template class BallShape<3>;
  template class CellSetShape<2>;
  template class CellSetShape<3>;

  namespace
  {
    const std::string box_documentation   = "a box with sides along the axes.";
    const std::string ball_documentation  = "a disc in 2D, a ball in 3D.";
    const std::string cells_documentation = "sets of cells of the mesh file.";
    const RegionShapeRegistry<2>::Entry<BoxShape<2>> box_2d("box",
                                                            box_documentation);
    const RegionShapeRegistry<3>::Entry<BoxShape<3>> box_3d("box",
                                                            box_documentation);
    const RegionShapeRegistry<2>::Entry<BallShape<2>>
      ball_2d("ball", ball_documentation);
    const RegionShapeRegistry<3>::Entry<BallShape<3>>
      ball_3d("ball", ball_documentation);
    const RegionShapeRegistry<2>::Entry<CellSetShape<2>>
      cells_2d("cells", cells_documentation);
    const RegionShapeRegistry<3>::Entry<CellSetShape<3>>
      cells_3d("cells", cells_documentation);
  } // namespace
} // namespace mpm_granular::Points
