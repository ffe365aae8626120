#include <mpm_granular/transfer/velocity_update.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  VelocityUpdate<dim>::find_motion(const NodalVelocities<dim> &velocities,
                                   const double                time_step,
                                   Grid::NodalFields<dim>     &fields)
  {
    const unsigned int n = fields.n_active_nodes();
    const double       c = pic_factor(time_step);
    change.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        change[i] =
          velocities.new_velocity[i] - (1. - c) * velocities.old_velocity[i];
        fields.motion[i].velocity = velocities.new_velocity[i];
        fields.motion[i].change   = change[i];
      }
  }

  template <int dim>
  void
  VelocityUpdate<dim>::add_momentum(Grid::NodalFields<dim> &fields,
                                    NodalVectors<dim>      &momentum) const
  {
    // The points' new momentum, seen from the nodes of the old positions, is
    // the action of the sampled consistent mass matrix: no pass over the
    // points.
    fields.add_mass_times(change, momentum);
  }

  template <int dim>
  void
  VelocityUpdate<dim>::set_change(Grid::NodalFields<dim> &fields) const
  {
    for (unsigned int i = 0; i < change.size(); ++i)
      fields.motion[i].change = change[i];
  }

  template class VelocityUpdate<2>;
  template class VelocityUpdate<3>;
} // namespace mpm_granular::Transfer
