#include <mpm_granular/transfer/mass_series.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  keep_what_mapping_loses(Grid::NodalFields<dim>      &fields,
                          std::vector<Tensor<1, dim>> &field)
  {
    std::vector<Tensor<1, dim>> momentum(field.size());
    fields.add_mass_times(field, momentum);
    for (unsigned int i = 0; i < field.size(); ++i)
      field[i] -= momentum[i] / fields.sums[i].mass;
  }

  template void
  keep_what_mapping_loses(Grid::NodalFields<2> &, std::vector<Tensor<1, 2>> &);
  template void
  keep_what_mapping_loses(Grid::NodalFields<3> &, std::vector<Tensor<1, 3>> &);
} // namespace mpm_granular::Transfer
