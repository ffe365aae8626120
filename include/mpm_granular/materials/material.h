#ifndef mpm_granular_materials_material_h
#define mpm_granular_materials_material_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/parameters/choice.h>

namespace mpm_granular::Materials
{
  /// A material: a law and its entries.
  template <int dim>
  struct Material : Parameters::ParameterGroup
  {
    Material();

    Parameters::Choice<ConstitutiveLaw<dim>> law;

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;
  };
} // namespace mpm_granular::Materials

#endif
