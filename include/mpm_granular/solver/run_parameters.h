#ifndef mpm_granular_solver_run_parameters_h
#define mpm_granular_solver_run_parameters_h

#include <mpm_granular/adaptivity/adaptation_parameters.h>
#include <mpm_granular/boundary/boundary_manager.h>
#include <mpm_granular/checkpoint/checkpoint_parameters.h>
#include <mpm_granular/materials/material.h>
#include <mpm_granular/mesh/mesh_source.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/momentum/body_force.h>
#include <mpm_granular/momentum/damping.h>
#include <mpm_granular/momentum/momentum_balance.h>
#include <mpm_granular/observables/observables_table.h>
#include <mpm_granular/output/output_parameters.h>
#include <mpm_granular/parameters/choice.h>
#include <mpm_granular/points/initial_state.h>
#include <mpm_granular/points/region.h>
#include <mpm_granular/solver/initial_equilibrium.h>
#include <mpm_granular/time/step_control.h>
#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/position_shift.h>
#include <mpm_granular/transfer/transfer_parameters.h>
#include <mpm_granular/transfer/velocity_update.h>

#include <string>
#include <vector>

namespace mpm_granular::Solver
{
  /// All settings of a run: those of every room, side by side.
  template <int dim>
  struct RunParameters : Parameters::ParameterGroup
  {
    RunParameters();

    double end_time           = 1.; ///< [s]
    bool   remove_lost_points = false;

    Parameters::Choice<Mesh::MeshSource<dim>>         mesh;
    Adaptivity::AdaptationParameters<dim>             adaptation;
    Parameters::NamedGroups<Materials::Material<dim>> materials;
    Parameters::NamedGroups<Points::Region<dim>>      regions;
    Points::InitialState<dim>                         initial_state;
    InitialEquilibrium<dim>                           equilibrium;
    Boundary::BoundarySettings<dim>                   boundary_conditions;
    Momentum::BodyForce<dim>                          body_force;
    Transfer::TransferParameters                      transfer;
    Parameters::Choice<Transfer::VelocityUpdate<dim>> velocity_update;
    Parameters::Choice<Transfer::Averaging<dim>>      averaging;
    Transfer::PositionShift<dim>                      position_shift;
    Momentum::MomentumParameters<dim>                 momentum;
    Parameters::Choice<Momentum::Damping<dim>>        damping;
    Time::StepParameters                              time_step;
    Mesh::PartitionParameters                         partition;
    Output::OutputParameters                          output;
    Observables::ObservablesTable<dim>                observables;
    Checkpoint::CheckpointParameters                  checkpoint;

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;
  };

  /// Entries and sections that may be changed when a run is continued: those
  /// that have no influence on the motion, but for round-off.
  const std::vector<std::string> &
  changeable_on_resume();
} // namespace mpm_granular::Solver

#endif
