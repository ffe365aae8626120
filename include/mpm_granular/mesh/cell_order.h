#ifndef mpm_granular_mesh_cell_order_h
#define mpm_granular_mesh_cell_order_h

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace mpm_granular::Mesh
{
  /// The active cells in the order in which a Hilbert curve passes the centres
  /// of those of level 0, child after child where these are refined.
  template <int dim>
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator>
  hilbert_order(const dealii::Triangulation<dim> &triangulation);

  /// The own cells of this rank, and behind them its ghost cells, both in the
  /// order of p4est: tree by tree along Morton's curve. The own cells of the
  /// ranks, one after the other, are in this order too.
  template <int dim>
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator>
  morton_order(
    const dealii::parallel::distributed::Triangulation<dim> &triangulation);
} // namespace mpm_granular::Mesh

#endif
