#ifndef mpm_granular_materials_coulomb_strength_h
#define mpm_granular_materials_coulomb_strength_h

#include <deal.II/base/parameter_handler.h>

namespace mpm_granular::Materials
{
  /// Friction, cohesion, dilatancy and tensile strength, as read.
  class CoulombStrength
  {
  public:
    /// Declares and binds 'Friction angle', 'Cohesion', 'Dilatancy angle' and
    /// 'Tensile strength'.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError unless dilatancy is at most friction and the tensile
    /// strength at most that of the apex.
    void
    check() const;

    /// phi [degrees].
    double
    friction_angle() const
    {
      return phi;
    }

    /// psi [degrees].
    double
    dilatancy_angle() const
    {
      return psi;
    }

    /// c [Pa].
    double
    cohesion() const
    {
      return shear_strength;
    }

    /// T [Pa].
    double
    tensile_strength() const
    {
      return tension;
    }

    /// The tension on all sides at the apex of the surface, c cot(phi) [Pa].
    double
    apex_tension() const;

  private:
    double phi            = 30.;
    double shear_strength = 0.;
    double psi            = 0.;
    double tension        = 0.;
  };
} // namespace mpm_granular::Materials

#endif
