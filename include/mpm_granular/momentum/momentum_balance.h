#ifndef mpm_granular_momentum_momentum_balance_h
#define mpm_granular_momentum_momentum_balance_h

#include <mpm_granular/momentum/damping.h>
#include <mpm_granular/momentum/mass_matrix.h>
#include <mpm_granular/parameters/choice.h>

#include <vector>

namespace mpm_granular::Momentum
{
  /// Settings of the momentum balance.
  template <int dim>
  struct MomentumParameters : Parameters::ParameterGroup
  {
    MomentumParameters();

    Parameters::Choice<MassMatrix<dim>> mass_matrix;
    double mass_cut_off = 1e-8; ///< of a full node's mass
    double mass_scaling = 1.;   ///< of inertia, not of weight (T33)

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;
  };

  /// Work done on the grid in one step, for the energy ledger (T28) [J].
  struct GridWork
  {
    double total    = 0; ///< by all impulses, at the mean nodal velocity
    double boundary = 0; ///< the part of constraints and tractions
    double damping  = 0; ///< that of damping, negative
    double weight   = 0; ///< that of gravity

    /// What re-mapping takes: work of the internal forces at the mean of old
    /// and new velocity, less that at the mean of old and straining velocity.
    double straining_loss = 0;
  };

  /// What a step's velocities depend on besides the fields.
  template <int dim>
  struct StepInput
  {
    double                                time_step;  ///< [s]
    double                                pic_factor; ///< c in (T14), 0..1
    dealii::Tensor<1, dim>                gravity;    ///< [m/s^2]
    const Grid::VelocityConstraints<dim> &constraints;
    const Damping<dim> *damping = nullptr; ///< none if nullptr
  };

  /// How far the forces on the nodes are from balance [N^2].
  struct ForceBalance
  {
    double rest     = 0; ///< square of what walls do not bear
    double external = 0; ///< square of weights and loads
    double internal = 0; ///< square of internal forces

    /// What is out of balance over the larger one of the others; 0 without
    /// forces.
    double
    ratio() const;
  };

  /**
   * The momentum balance on the active nodes: old velocity from the points'
   * momentum, new velocity from the forces (T12), and the re-mapped velocity of
   * MUSL (T16).
   */
  template <int dim>
  class MomentumBalance
  {
  public:
    MomentumBalance(const MomentumParameters<dim>   &parameters,
                    const Mesh::BackgroundMesh<dim> &mesh,
                    const double                     density);

    /// Prepares for new cells of the mesh.
    void
    reinit();

    /// Sets NodeMotion::straining to the velocity of the points' momentum, with
    /// constraints: what strains points before the step (USF).
    void
    map_velocity(Grid::NodalFields<dim>               &fields,
                 const Grid::VelocityConstraints<dim> &constraints);

    /// Finds the velocities before and after the step.
    void
    advance(Grid::NodalFields<dim> &fields, const StepInput<dim> &step);

    /// The velocity that the points' momentum gives, by slot [m/s]; after
    /// advance().
    const NodalVectors<dim> &
    velocity_before() const
    {
      return old_velocity;
    }

    /// The new velocity, by slot [m/s]; after advance().
    const NodalVectors<dim> &
    velocity_after() const
    {
      return new_velocity;
    }

    /// The constraints in the step, with those of walls that only push; after
    /// advance().
    const Grid::VelocityConstraints<dim> &
    holding(const StepInput<dim> &step) const
    {
      return step.constraints.has_contact ? contact : step.constraints;
    }

    /// NodeMotion::straining = NodeMotion::velocity (USL).
    void
    strain_with_velocity(Grid::NodalFields<dim> &fields) const;

    /// The part of the momentum before the step that the points keep, by slot
    /// [kg m/s]: to be completed to their new momentum; after advance().
    NodalVectors<dim> &
    kept_momentum(const StepInput<dim> &step);

    /// NodeMotion::straining = the velocity that the points' new momentum gives
    /// (MUSL), which is what kept_momentum() has been made.
    void
    remap_velocity(Grid::NodalFields<dim> &fields, const StepInput<dim> &step);

    /// Work of the step, after all velocities are known: this rank's part of a
    /// sum over the ranks.
    GridWork
    work(const Grid::NodalFields<dim> &fields, const StepInput<dim> &step);

    /// How far the forces at the start of the step, after advance(), are from
    /// balance: this rank's part of sums over the ranks.
    ForceBalance
    force_balance(const Grid::NodalFields<dim> &fields,
                  const StepInput<dim>         &step) const;

  private:
    /// All forces on a node but the reactions of constraints.
    dealii::Tensor<1, dim>
    force(const Grid::NodalFields<dim> &fields,
          const StepInput<dim>         &step,
          const unsigned int            slot) const;

    /// Adds the impulses of damping to the momenta in scratch.
    void
    add_damping(const StepInput<dim> &step);

    MassMatrix<dim>                 &mass;
    const Mesh::BackgroundMesh<dim> &mesh;
    const double      least_density; ///< of a node: below, forces are dropped
    const double      mass_scaling;
    NodalVectors<dim> forces; ///< on the nodes at the beginning of the step
    NodalVectors<dim> old_momentum;
    NodalVectors<dim> old_velocity;
    NodalVectors<dim> new_velocity;
    NodalVectors<dim> remapped_velocity;
    NodalVectors<dim> damping_impulse; ///< over the mass scaling; or empty
    NodalVectors<dim> scratch;

    Grid::VelocityConstraints<dim> contact; ///< found in advance()
  };
} // namespace mpm_granular::Momentum

#endif
