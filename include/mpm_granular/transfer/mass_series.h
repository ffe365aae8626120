#ifndef mpm_granular_transfer_mass_series_h
#define mpm_granular_transfer_mass_series_h

#include <mpm_granular/grid/nodal_fields.h>

#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * What a nodal field loses on its way to the points and back: replaces u by
   * (I - M_l^-1 M) u, with the sampled consistent and the lumped mass matrix
   * (T11). Sums of its powers approximate the inverse of the consistent matrix
   * (T65). Collective.
   *
   * @param field u, one vector per active node, by slot.
   */
  template <int dim>
  void
  keep_what_mapping_loses(Grid::NodalFields<dim>              &fields,
                          std::vector<dealii::Tensor<1, dim>> &field);
} // namespace mpm_granular::Transfer

#endif
