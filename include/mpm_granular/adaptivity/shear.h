#ifndef mpm_granular_adaptivity_shear_h
#define mpm_granular_adaptivity_shear_h

#include <mpm_granular/adaptivity/criterion.h>

namespace mpm_granular::Adaptivity
{
  /// Cells so fine that the shear across each of them is small (T81).
  template <int dim>
  class Shear : public Criterion<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    prepare(const State<dim> &state) override;

    unsigned int
    wanted_level(const State<dim>  &state,
                 const unsigned int cell) const override;

  private:
    double       largest_jump    = 0.1;
    double       coarsening_part = 0.25;
    double       speed           = 0.; ///< [m/s]; 0: that of the grid
    unsigned int level           = highest_level;
    double       speed_in_use    = 0.; ///< [m/s]
  };
} // namespace mpm_granular::Adaptivity

#endif
