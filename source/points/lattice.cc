#include <mpm_granular/points/lattice.h>

#include <cmath>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  void
  Lattice<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Spacing",
                      spacing,
                      "Distance of neighbouring points in each direction; it "
                      "should divide the sides of the region. Units: m.");
  }

  template <int dim>
  void
  Lattice<dim>::check() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      require(spacing[d] > 0.,
              "'Spacing' of a lattice of points must be positive in every "
              "direction; in direction " +
                std::to_string(d) + " it is " + std::to_string(spacing[d]) +
                ".");
  }

  template <int dim>
  std::vector<Seed<dim>>
  Lattice<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                      const RegionShape<dim>          &shape,
                      const std::string & /*input_file*/) const
  {
    const auto corners = shape.bounding_box(mesh).get_boundary_points();
    std::array<unsigned int, 3> n{{1, 1, 1}};
    double                      volume = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n[d] = std::max(1.,
                        std::round((corners.second[d] - corners.first[d]) /
                                   spacing[d]));
        volume *= spacing[d];
      }

    std::vector<Point<dim>> places;
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          {
            const std::array<unsigned int, 3> index{{i, j, k}};
            Point<dim>                        x = corners.first;
            for (unsigned int d = 0; d < dim; ++d)
              x[d] += (index[d] + .5) * spacing[d];
            places.push_back(x);
          }

    const auto             cells = mesh.locate(places);
    std::vector<Seed<dim>> seeds;
    for (unsigned int i = 0; i < places.size(); ++i)
      {
        if (cells[i] == Mesh::no_cell)
          throw InputError("A point of the lattice lies outside the mesh, at " +
                           Mesh::as_text(places[i]) + ".");
        if (cells[i] != Mesh::unknown_cell &&
            shape.contains(places[i], cells[i]))
          seeds.push_back({places[i], cells[i], volume, i});
      }
    return seeds;
  }

  template class Lattice<2>;
  template class Lattice<3>;

  namespace
  {
    const std::string documentation = "a regular lattice.";
    const PointLayoutRegistry<2>::Entry<Lattice<2>> lattice_2d("lattice",
                                                               documentation);
    const PointLayoutRegistry<3>::Entry<Lattice<3>> lattice_3d("lattice",
                                                               documentation);
  } // namespace
} // namespace mpm_granular::Points
