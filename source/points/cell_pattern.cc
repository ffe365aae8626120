#include <mpm_granular/points/cell_pattern.h>

#include <algorithm>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  std::vector<Seed<dim>>
  repeat(const CellPattern               &pattern,
         const Mesh::BackgroundMesh<dim> &mesh,
         const RegionShape<dim>          &shape)
  {
    const auto            &places = pattern.places;
    std::vector<Seed<dim>> seeds;
    for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
      for (unsigned int i = 0; i < places.size(); ++i)
        {
          const auto nodes = mesh.nodes(cell);
          Point<dim> x;
          for (unsigned int k = 0; k < nodes.size(); ++k)
            x += places[i].shape_values[k] * mesh.node_position(nodes[k]);
          if (shape.contains(x, cell))
            seeds.push_back(
              {x,
               cell,
               mesh.cell_volume(cell) * places[i].share,
               std::uint64_t(mesh.global_cell(cell)) * places.size() + i});
        }
    return seeds;
  }

  template <int dim>
  void
  check_points_per_cell(const unsigned int               given,
                        const std::vector<unsigned int> &valid,
                        const Mesh::BackgroundMesh<dim> &mesh)
  {
    std::string numbers;
    for (const unsigned int number : valid)
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
    require(std::find(valid.begin(), valid.end(), given) != valid.end(),
            "'Points per cell' must be one of " + numbers + " in " +
              Mesh::name_of_cells(mesh.cell_kind(), dim) +
              "; given: " + std::to_string(given) + ".");
  }

  template std::vector<Seed<2>>
  repeat(const CellPattern &,
         const Mesh::BackgroundMesh<2> &,
         const RegionShape<2> &);
  template std::vector<Seed<3>>
  repeat(const CellPattern &,
         const Mesh::BackgroundMesh<3> &,
         const RegionShape<3> &);
  template void
  check_points_per_cell(const unsigned int,
                        const std::vector<unsigned int> &,
                        const Mesh::BackgroundMesh<2> &);
  template void
  check_points_per_cell(const unsigned int,
                        const std::vector<unsigned int> &,
                        const Mesh::BackgroundMesh<3> &);
} // namespace mpm_granular::Points
