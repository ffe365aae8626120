#ifndef mpm_granular_transfer_apic_h
#define mpm_granular_transfer_apic_h

#include <mpm_granular/transfer/velocity_update.h>

namespace mpm_granular::Transfer
{
  /**
   * APIC: points take over the grid's velocity and the gradient that strains
   * them, and give the nodes the velocity of this linear field at their places
   * (T68). Linear fields, and with them rotations, pass from points to grid
   * unchanged, and with USL from grid to points, too.
   *
   * Jiang, Schroeder, Selle, Teran and Stomakhin (2015).
   */
  template <int dim>
  class Apic : public VelocityUpdate<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    /// What points give is the momentum of the lumped matrix.
    bool
    needs_lumped_mass() const override
    {
      return true;
    }

    /// Those of the cells alone, if they are not damped, feed on themselves at
    /// the edge of a body.
    bool
    needs_means_of_gradients() const override
    {
      return damping_rate == 0.;
    }

    /// The gradient of the velocity, row by row [1/s].
    std::vector<std::string>
    history_names() const override;

    void
    initialize(Points::PointArrays<dim>     &points,
               const std::size_t             p,
               const dealii::Tensor<2, dim> &gradient) const override;

    /// The gradient of USF is that of the step before.
    bool
    handles_stress_first() const override
    {
      return false;
    }

    /// What points give to nodes, and that gradients give it back (T68), are
    /// properties of linear functions.
    bool
    handles_wide_functions() const override
    {
      return false;
    }

    double
    pic_factor(const double time_step) const override;

    void
    find_motion(const NodalVelocities<dim> &velocities,
                const double                time_step,
                Grid::NodalFields<dim>     &fields) override;

    /// Linear fields of the points are handed on as they are, and what the step
    /// adds as in FLIP.
    void
    add_momentum(Grid::NodalFields<dim> &fields,
                 NodalVectors<dim>      &momentum) const override;

    void
    take(const PointBlock<dim>    &block,
         Points::PointArrays<dim> &points) const override;

    void
    give(const Mesh::BackgroundMesh<dim> &mesh,
         const Points::PointArrays<dim>  &points,
         const PointBlock<dim>           &block,
         Grid::NodalFields<dim>          &fields) const override;

  private:
    double            damping_rate = 0.; ///< of gradients [1/s]
    double            kept         = 1.; ///< of the old velocities, in a step
    NodalVectors<dim> increment;         ///< v' less what is kept of v [m/s]
  };
} // namespace mpm_granular::Transfer

#endif
