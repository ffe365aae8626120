#include <mpm_granular/transfer/nodal_pressure.h>

namespace mpm_granular::Transfer
{
  template <int dim>
  std::vector<double>
  nodal_pressure(const Mesh::BackgroundMesh<dim> &mesh,
                 const Points::PointArrays<dim>  &points,
                 Grid::NodalFields<dim>          &fields)
  {
    enum
    {
      volume,
      pressure
    };
    using Sums = std::array<double, 2>;
    std::vector<Sums> sums(fields.n_active_nodes(), Sums());
    mesh.visit([&](const auto &cells) {
      for (unsigned int p = 0; p < points.size(); ++p)
        {
          const auto &cell         = cells[points.cell[p]];
          const auto  shape_values = cell.shape_values(points.location(p));
          for (unsigned int k = 0; k < shape_values.size(); ++k)
            {
              const double share = shape_values[k] * points.volume[p];
              fields.hanging.add_at(sums,
                                    fields.slot_of(cell.node[k]),
                                    Sums{{share, share * points.pressure(p)}});
            }
        }
    });
    fields.shared.sum(sums);
    std::vector<double> means;
    for (const auto &node : sums)
      means.push_back(node[volume] > 0. ? node[pressure] / node[volume] : 0.);
    return means;
  }

#define INSTANTIATE(dim)                       \
  template std::vector<double> nodal_pressure( \
    const Mesh::BackgroundMesh<dim> &,         \
    const Points::PointArrays<dim> &,          \
    Grid::NodalFields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
