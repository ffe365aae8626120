#include <mpm_granular/momentum/momentum_balance.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  MomentumParameters<dim>::MomentumParameters()
    : mass_matrix("lumped")
  {}

  template <int dim>
  void
  MomentumParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    mass_matrix.add_parameters(prm,
                               "Mass matrix",
                               "Between velocity and momentum of nodes:");
    prm.add_parameter("Mass cut-off",
                      mass_cut_off,
                      "A node with less than this part of the mass of a full "
                      "node takes no force: its acceleration would be huge and "
                      "without meaning. Units: -.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Mass scaling",
                      mass_scaling,
                      "Factor on inertia, not on weight; the time step grows "
                      "with its root. For quasi-static runs, which need a "
                      "'Damping'. Units: -.",
                      Patterns::Double(1.));
  }

  double
  ForceBalance::ratio() const
  {
    const double scale = std::max(external, internal);
    return scale > 0. ? std::sqrt(rest / scale) : 0.;
  }

  template <int dim>
  void
  MomentumParameters<dim>::check() const
  {
    mass_matrix->check();
  }

  template <int dim>
  MomentumBalance<dim>::MomentumBalance(
    const MomentumParameters<dim>   &parameters,
    const Mesh::BackgroundMesh<dim> &mesh,
    const double                     density)
    : mass(*parameters.mass_matrix)
    , mesh(mesh)
    , least_density(parameters.mass_cut_off * density)
    , mass_scaling(parameters.mass_scaling)
  {
    reinit();
  }

  template <int dim>
  void
  MomentumBalance<dim>::reinit()
  {
    mass.reinit(mesh);
  }

  template <int dim>
  Tensor<1, dim>
  MomentumBalance<dim>::force(const Grid::NodalFields<dim> &fields,
                              const StepInput<dim>         &step,
                              const unsigned int            slot) const
  {
    const auto    &node = fields.sums[slot];
    Tensor<1, dim> sum  = node.mass * step.gravity;
    if (node.mass > least_density * mesh.node_volume(fields.active_nodes[slot]))
      sum += node.force + node.load;
    return sum;
  }

  template <int dim>
  void
  MomentumBalance<dim>::map_velocity(
    Grid::NodalFields<dim>               &fields,
    const Grid::VelocityConstraints<dim> &constraints)
  {
    const unsigned int n = fields.n_active_nodes();
    scratch.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      scratch[i] = fields.sums[i].momentum;
    mass.assemble(fields);
    mass.solve(scratch, &constraints, old_velocity);
    for (unsigned int i = 0; i < n; ++i)
      fields.motion[i].straining = old_velocity[i];
    fields.extend_motion();
  }

  template <int dim>
  void
  MomentumBalance<dim>::advance(Grid::NodalFields<dim> &fields,
                                const StepInput<dim>   &step)
  {
    const unsigned int n        = fields.n_active_nodes();
    const double       duration = step.time_step / mass_scaling; // (T33)
    old_momentum.resize(n);
    forces.resize(n);
    scratch.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        old_momentum[i] = fields.sums[i].momentum;
        forces[i]       = force(fields, step, i);
        scratch[i]      = old_momentum[i] + duration * forces[i];
      }
    add_damping(step);
    mass.assemble(fields);
    mass.solve(old_momentum, nullptr, old_velocity);
    if (step.constraints.has_contact)
      {
        mass.solve(scratch, nullptr, new_velocity);
        contact = step.constraints.resolve_contact(new_velocity); // (T34)
      }
    else
      mass.solve(scratch, &step.constraints, new_velocity);
  }

  template <int dim>
  void
  MomentumBalance<dim>::add_damping(const StepInput<dim> &step)
  {
    damping_impulse.clear();
    if (step.damping == nullptr)
      return;
    NodalVectors<dim> impulse(scratch.size());
    for (unsigned int i = 0; i < scratch.size(); ++i)
      impulse[i] = scratch[i] - old_momentum[i];
    step.damping->compute(
      step.time_step, step.constraints, old_momentum, impulse, damping_impulse);
    for (unsigned int i = 0; i < scratch.size(); ++i)
      scratch[i] += damping_impulse[i];
  }

  template <int dim>
  void
  MomentumBalance<dim>::strain_with_velocity(
    Grid::NodalFields<dim> &fields) const
  {
    for (auto &node : fields.motion)
      node.straining = node.velocity;
  }

  template <int dim>
  NodalVectors<dim> &
  MomentumBalance<dim>::kept_momentum(const StepInput<dim> &step)
  {
    for (unsigned int i = 0; i < scratch.size(); ++i)
      scratch[i] = (1. - step.pic_factor) * old_momentum[i];
    return scratch;
  }

  template <int dim>
  void
  MomentumBalance<dim>::remap_velocity(Grid::NodalFields<dim> &fields,
                                       const StepInput<dim>   &step)
  {
    mass.solve(scratch, &holding(step), remapped_velocity);
    for (unsigned int i = 0; i < remapped_velocity.size(); ++i)
      fields.motion[i].straining = remapped_velocity[i];
    fields.extend_motion();
  }

  template <int dim>
  GridWork
  MomentumBalance<dim>::work(const Grid::NodalFields<dim> &fields,
                             const StepInput<dim>         &step)
  {
    NodalVectors<dim> &new_momentum = scratch;
    mass.multiply(new_velocity, new_momentum);
    GridWork work;
    for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
      {
        if (!fields.shared.counts(i))
          continue;
        const auto          &node = fields.sums[i];
        const Tensor<1, dim> impulse =
          mass_scaling * (new_momentum[i] - old_momentum[i]);
        const Tensor<1, dim> mean   = .5 * (old_velocity[i] + new_velocity[i]);
        const Tensor<1, dim> others = step.time_step * (forces[i] - node.load);
        work.total += impulse * mean;
        work.boundary += (impulse - others) * mean;
        work.weight += step.time_step * node.mass * (step.gravity * mean);
        if (!damping_impulse.empty())
          work.damping += mass_scaling * (damping_impulse[i] * mean);
        work.straining_loss += .5 * step.time_step * node.force *
                               (fields.motion[i].straining - new_velocity[i]);
      }
    work.boundary -= work.damping;
    return work;
  }

  template <int dim>
  ForceBalance
  MomentumBalance<dim>::force_balance(const Grid::NodalFields<dim> &fields,
                                      const StepInput<dim>         &step) const
  {
    NodalVectors<dim> rest(fields.n_active_nodes());
    for (unsigned int i = 0; i < rest.size(); ++i)
      rest[i] = force(fields, step, i);
    holding(step).project(rest);

    ForceBalance balance;
    for (unsigned int i = 0; i < rest.size(); ++i)
      if (fields.shared.counts(i))
        {
          const auto &node = fields.sums[i];
          balance.rest += rest[i].norm_square();
          balance.external +=
            (node.mass * step.gravity + node.load).norm_square();
          balance.internal += node.force.norm_square();
        }
    return balance;
  }

  template struct MomentumParameters<2>;
  template struct MomentumParameters<3>;
  template class MomentumBalance<2>;
  template class MomentumBalance<3>;
} // namespace mpm_granular::Momentum
