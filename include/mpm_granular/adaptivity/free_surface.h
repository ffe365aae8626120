#ifndef mpm_granular_adaptivity_free_surface_h
#define mpm_granular_adaptivity_free_surface_h

#include <mpm_granular/adaptivity/criterion.h>

namespace mpm_granular::Adaptivity
{
  /// A level for the cells with points that touch cells without.
  template <int dim>
  class FreeSurface : public Criterion<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    unsigned int
    wanted_level(const State<dim>  &state,
                 const unsigned int cell) const override;

  private:
    unsigned int level = highest_level;
  };
} // namespace mpm_granular::Adaptivity

#endif
