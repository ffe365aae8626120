#ifndef tests_seeds_h
#define tests_seeds_h

#include <mpm_granular/points/point_layout.h>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// Points to be made at some places, which all ranks give: on each rank those
  /// in cells it knows as its own.
  template <int dim>
  std::vector<Points::Seed<dim>>
  seeds_at(const Mesh::BackgroundMesh<dim> &mesh,
           const std::vector<Point<dim>>   &places,
           const double                     volume)
  {
    const auto                     cells = mesh.locate(places);
    std::vector<Points::Seed<dim>> seeds;
    for (unsigned int i = 0; i < places.size(); ++i)
      if (cells[i] < mesh.n_cells())
        seeds.push_back({places[i], cells[i], volume, i});
    return seeds;
  }
} // namespace Test

#endif
