#ifndef mpm_granular_observables_deposit_area_h
#define mpm_granular_observables_deposit_area_h

#include <mpm_granular/observables/observable.h>

namespace mpm_granular::Observables
{
  /**
   * Area of the body seen from the side, from the floor up to its surface
   * [m^2]: whether it keeps its volume, loosens, or falls through the mesh.
   */
  template <int dim>
  class DepositArea : public Observable<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    std::vector<std::string>
    columns() const override;

    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;

  private:
    double bin_width = 0.; ///< [m]; 0: one mean cell size
  };
} // namespace mpm_granular::Observables

#endif
