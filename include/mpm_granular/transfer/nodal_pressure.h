#ifndef mpm_granular_transfer_nodal_pressure_h
#define mpm_granular_transfer_nodal_pressure_h

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/points/point_arrays.h>

#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * The mean pressure around each active node, sum_p N_ip V_p p_p over sum_p
   * N_ip V_p, by slot [Pa]: what is smooth in the pressures of the points. The
   * active nodes must belong to the present places of the points. Collective.
   */
  template <int dim>
  std::vector<double>
  nodal_pressure(const Mesh::BackgroundMesh<dim> &mesh,
                 const Points::PointArrays<dim>  &points,
                 Grid::NodalFields<dim>          &fields);
} // namespace mpm_granular::Transfer

#endif
