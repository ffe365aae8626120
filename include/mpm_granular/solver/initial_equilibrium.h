#ifndef mpm_granular_solver_initial_equilibrium_h
#define mpm_granular_solver_initial_equilibrium_h

#include <mpm_granular/momentum/local_damping.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <limits>
#include <string>

namespace mpm_granular::Solver
{
  /// How far a body is from equilibrium (T35).
  struct Unrest
  {
    /// Forces out of balance over weights or internal forces.
    double force_ratio = std::numeric_limits<double>::max();

    /// Kinetic over elastic energy.
    double energy_ratio = std::numeric_limits<double>::max();

    /// Both in words.
    std::string
    text() const;
  };

  /// Settings of the stage before time 0 that finds the stresses in equilibrium
  /// with gravity and loads (T35).
  template <int dim>
  struct InitialEquilibrium : Parameters::ParameterGroup
  {
    bool                        is_wanted        = false;
    double                      force_tolerance  = 1e-4;
    double                      energy_tolerance = 1e-6;
    double                      maximum_time     = 10.; ///< [s]
    Momentum::LocalDamping<dim> damping;

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    /// Whether forces and motion are within the tolerances.
    bool
    is_reached(const Unrest &unrest) const;
  };
} // namespace mpm_granular::Solver

#endif
