#ifndef mpm_granular_adaptivity_point_number_h
#define mpm_granular_adaptivity_point_number_h

#include <mpm_granular/adaptivity/criterion.h>

namespace mpm_granular::Adaptivity
{
  /// Cells so fine that none has more than a number of points (T80).
  template <int dim>
  class PointNumber : public Criterion<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    unsigned int
    wanted_level(const State<dim>  &state,
                 const unsigned int cell) const override;

  private:
    unsigned int largest_number = 1;
  };
} // namespace mpm_granular::Adaptivity

#endif
