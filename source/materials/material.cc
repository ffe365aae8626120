#include <mpm_granular/materials/material.h>

namespace mpm_granular::Materials
{
  template <int dim>
  Material<dim>::Material()
    : law("Drucker-Prager viscoplastic")
  {}

  template <int dim>
  void
  Material<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    law.add_parameters(prm, "Law", "Constitutive law:");
  }

  template <int dim>
  void
  Material<dim>::check() const
  {
    law->check();
  }

  template struct Material<2>;
  template struct Material<3>;
} // namespace mpm_granular::Materials
