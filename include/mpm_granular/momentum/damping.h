#ifndef mpm_granular_momentum_damping_h
#define mpm_granular_momentum_damping_h

#include <mpm_granular/core/registry.h>
#include <mpm_granular/grid/velocity_constraints.h>
#include <mpm_granular/momentum/mass_matrix.h>
#include <mpm_granular/parameters/parameter_group.h>

namespace mpm_granular::Momentum
{
  /**
   * Forces on the nodes that bring a body to rest where only the state at rest
   * matters (T31). They vanish with motion or with the force out of balance, so
   * the state at rest is that of the forces without them.
   */
  template <int dim>
  class Damping : public Parameters::ParameterGroup
  {
  public:
    /// Whether there is any; otherwise nothing needs to be computed.
    virtual bool
    is_active() const
    {
      return true;
    }

    /**
     * The impulses of damping in a step of @p time_step, one per active node.
     * Components that are prescribed, or along the normal of a wall, take none.
     *
     * @param momentum at the start of the step, by slot.
     * @param impulse of all forces but reactions, by slot; of the scaled
     *   inertia, as the momentum is.
     */
    void
    compute(const double                          time_step,
            const Grid::VelocityConstraints<dim> &constraints,
            NodalVectors<dim>                     momentum,
            NodalVectors<dim>                     impulse,
            NodalVectors<dim>                    &result) const;

  private:
    /// Adds the impulses, from momenta and impulses without prescribed
    /// components.
    virtual void
    add(const double             time_step,
        const NodalVectors<dim> &momentum,
        const NodalVectors<dim> &impulse,
        NodalVectors<dim>       &result) const = 0;
  };

  template <int dim>
  using DampingRegistry = Core::Registry<Damping<dim>>;
} // namespace mpm_granular::Momentum

#endif
