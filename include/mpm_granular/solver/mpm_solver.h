#ifndef mpm_granular_solver_mpm_solver_h
#define mpm_granular_solver_mpm_solver_h

#include <mpm_granular/adaptivity/adaptation.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/observables/snapshot.h>
#include <mpm_granular/points/material_points.h>
#include <mpm_granular/solver/agreement.h>
#include <mpm_granular/solver/run_parameters.h>
#include <mpm_granular/solver/step_times.h>
#include <mpm_granular/solver/sweep.h>
#include <mpm_granular/transfer/nodal_pressure.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace mpm_granular::Solver
{
  /**
   * The material point method: a mesh, points on it, and the time step that
   * advances them (section 2 of doc/theory.md). It computes; what is written
   * and when is up to Run.
   *
   * Each MPI rank has the points in its part of the mesh. All member functions
   * that are not const are collective.
   */
  template <int dim>
  class MPMSolver
  {
  public:
    /**
     * Makes mesh and points and sets the initial state.
     *
     * @param parameters must live as long.
     * @param input_file the parameter file that file names are relative to.
     * @param communicator of the ranks that share the computation.
     * @throws InputError where the parameters cannot be right.
     */
    MPMSolver(const RunParameters<dim> &parameters,
              const std::string        &input_file,
              const MPI_Comm            communicator);

    /**
     * Advances by one time step.
     *
     * @param next_event a time that the step does not pass [s].
     * @param requests of this rank; requests() then tells those of all.
     * @throws ComputationError if the result makes no sense.
     */
    void
    advance_one_step(const double next_event, const Requests &requests = {});

    /// Whether the stage before time 0 is on.
    bool
    is_settling() const
    {
      return current_time < 0.;
    }

    /**
     * Advances by one step of the stage before time 0, which brings stresses
     * into equilibrium (T35): points stay where they are, walls are at rest,
     * gravity and loads are those of time 0, motion is damped.
     *
     * @param next_event and @p requests as for advance_one_step().
     * @throws ComputationError if the result makes no sense.
     */
    void
    settle_one_step(const double next_event, const Requests &requests = {});

    /// How far from equilibrium the stage was some steps ago.
    const Unrest &
    last_unrest() const
    {
      return unrest;
    }

    /// Ends the stage: time 0, with the stresses there are, without motion,
    /// and the history that belongs to the stresses.
    void
    start_from_rest();

    /**
     * All that the next step depends on, for checkpoints. Read on the number of
     * processes that wrote it, the run goes on bit for bit; on another one the
     * grid is summed from the points again, which differs by round-off.
     *
     * @throws InputError if the state belongs to another mesh.
     */
    void
    serialize(Core::Archive &archive);

    /// The state now, for observables and output.
    Observables::Snapshot<dim>
    snapshot() const;

    const Mesh::BackgroundMesh<dim> &
    background_mesh() const
    {
      return mesh;
    }

    const Mesh::Partition<dim> &
    cell_partition() const
    {
      return partition;
    }

    /// Those of this rank.
    const Points::MaterialPoints<dim> &
    material_points() const
    {
      return points;
    }

    const Grid::NodalFields<dim> &
    nodal_fields() const
    {
      return fields;
    }

    /// Sums mass and momentum of the nodes from the points as they are now. The
    /// next step does so anyway; this is for looking at them in between.
    void
    gather_nodes()
    {
      fields.gather_nodes();
    }

    /// The mean pressure around the active nodes, by slot [Pa]; after
    /// gather_nodes().
    std::vector<double>
    nodal_pressure()
    {
      return Transfer::nodal_pressure(mesh, points.arrays(), fields);
    }

    /// Completes values at nodes, set by the rank that counts the node and zero
    /// elsewhere, so that each rank has them in all of its own cells.
    /// @param values @p n_values numbers per node of the mesh.
    void
    spread_to_own_cells(std::vector<double> &values,
                        const unsigned int   n_values)
    {
      fields.shared.spread(values, n_values);
    }

    const std::vector<const Materials::ConstitutiveLaw<dim> *> &
    material_laws() const
    {
      return laws;
    }

    double
    time() const ///< [s]
    {
      return current_time;
    }

    unsigned int
    step() const
    {
      return n_steps;
    }

    double
    time_step() const ///< the last one [s]
    {
      return last_time_step;
    }

    double
    kinetic_energy() const ///< with the scaled mass [J], in 2D [J/m]
    {
      return parameters.momentum.mass_scaling * agreement.kinetic_energy;
    }

    std::uint64_t
    n_points() const ///< on all ranks
    {
      return agreement.n_points;
    }

    std::size_t
    n_lost_points() const ///< by this rank
    {
      return n_lost;
    }

    const Requests &
    requests() const ///< of any rank, in the last step
    {
      return agreement.requests;
    }

    /// Limits of the time step, with the scaled mass, for the present active
    /// cells of all ranks.
    const Time::StepLimits &
    step_limits() const
    {
      return agreement.limits;
    }

    /// How the work was kept shared out among the ranks so far.
    struct LoadBalance
    {
      unsigned int n_redistributions = 0;  ///< how often cells got new owners
      unsigned int n_migrations      = 0;  ///< how often points went elsewhere
      double       seconds           = 0.; ///< wall time this took
      double       largest_imbalance =
        0.; ///< most points of a rank over mean, less 1
    };

    const LoadBalance &
    load_balance() const
    {
      return load;
    }

    /// How the mesh was adapted so far.
    struct MeshChanges
    {
      unsigned int n_adaptations = 0;  ///< in which it became another mesh
      unsigned int n_limited     = 0;  ///< in which cells would be too many
      double       seconds       = 0.; ///< wall time of looking and changing
    };

    const MeshChanges &
    mesh_changes() const
    {
      return changes;
    }

    /// What follows from the body where the input leaves it open.
    struct Scheme
    {
      std::string averaging;   ///< name of the one that is used
      double      filter_rate; ///< of pressures [1/s]
      double      shift_rate;  ///< of positions [1/s]
    };

    const Scheme &
    chosen_scheme() const
    {
      return scheme;
    }

    /// Of advance_one_step(), on this rank.
    const StepTimes &
    step_times() const
    {
      return times;
    }

    /// Remarks on the input that do not stop a run.
    const std::vector<std::string> &
    warnings() const
    {
      return remarks;
    }

    /// Memory of all that the computation holds on this rank [bytes].
    std::size_t
    memory_consumption() const;

  private:
    void
    check_contact() const;
    void
    create_points(const std::string &input_file);
    void
    create_points_on_adapted_mesh(const std::string &input_file);
    std::vector<std::uint8_t>
    wanted_levels();
    void
    adapt_mesh();
    bool
    adapt_mesh_once();
    void
    split_and_merge();
    void
    serialize_mesh(Core::Archive &archive);
    void
    set_initial_state();
    void
    prepare_settling();
    void
    choose_scheme();
    /// By material, the volume per mass that may be filled [m^3/kg].
    std::vector<double>
    largest_specific_volumes() const;
    void
    find_cell_limits();
    void
    find_cell_sizes();
    void
    smooth_pressures();
    void
    find_velocities(const Momentum::StepInput<dim> &step);
    void
    shift_positions(const Momentum::StepInput<dim> &step);
    void
    remap_velocity(const Momentum::StepInput<dim> &step);
    void
    move_and_strain(const Momentum::StepInput<dim> &step);
    void
    strain_in_place(const Momentum::StepInput<dim> &step);
    void
    measure_unrest(const Momentum::StepInput<dim> &step);
    void
    count_lost_power(const double time_step);
    Momentum::GridWork
    update_ledger(const Momentum::StepInput<dim> &step,
                  const SweepResult              &sweep_result);
    void
    finish_step(const double    time_step,
                const double    next_event,
                const Requests &requests);
    void
    check_points(const SweepResult &sweep_result);
    void
    keep_order();
    void
    agree_on_state(const Requests &requests = {});
    void
    balance();
    void
    redistribute(const std::uint32_t weight_of_point = 1);
    void
    reinit_on_mesh();
    void
    project();

    /// What the steps after time 0 are damped by; nullptr for nothing.
    const Momentum::Damping<dim> *
    damping() const
    {
      return parameters.damping->is_active() ? &*parameters.damping : nullptr;
    }

    /// The time whose gravity and loads hold now [s].
    double
    load_time() const
    {
      return std::max(current_time, 0.);
    }

    /// Calls @p action, which may fail on this rank alone; the error is kept
    /// for agree_on_state().
    void
    on_this_rank(const std::function<void()> &action);

    const RunParameters<dim>                            &parameters;
    Mesh::BackgroundMesh<dim>                            mesh;
    Mesh::Partition<dim>                                 partition;
    Adaptivity::Adaptation<dim>                          adaptation;
    std::vector<const Materials::ConstitutiveLaw<dim> *> laws;
    Points::MaterialPoints<dim>                          points;
    Grid::NodalFields<dim>                               fields;
    Boundary::BoundaryManager<dim>                       boundary;
    Momentum::MomentumBalance<dim>                       momentum;
    Transfer::Averaging<dim>                            &averaging;
    Transfer::VelocityUpdate<dim>                       &velocity_update;
    Time::StepControl                                    step_control;
    Transfer::SettledPressures<dim>                      settled_pressures;
    Sweep<dim>                                           sweep;

    /// What a cell, if it is active, limits the time step by.
    struct CellLimits
    {
      double critical_step; ///< stability limit [s]
      double altitude;      ///< [m]
    };

    std::vector<CellLimits>   cell_limits; ///< by flat cell
    std::vector<double>       cell_sizes;  ///< if positions are shifted [m]
    std::vector<std::string>  remarks;
    Scheme                    scheme;
    Points::Motion            motion;
    Observables::EnergyLedger ledger;
    double                    current_time    = 0.;
    double                    last_time_step  = 0.;
    double                    since_filter    = 0.; ///< of pressures [s]
    unsigned int              n_steps         = 0;
    std::size_t               n_lost          = 0;
    std::size_t               n_runs          = 0; ///< of the last sweep
    std::size_t               n_runs_in_order = 0; ///< on all ranks

    Unrest       unrest;
    Agreement    agreement;
    std::string  error;                   ///< of this rank; empty if none
    bool         is_out_of_reach = false; ///< a point of this rank
    unsigned int last_balance    = 0;     ///< step
    LoadBalance  load;
    unsigned int last_adaptation = 0;  ///< step
    double       displacement    = 0.; ///< since then, at most [m]
    MeshChanges  changes;
    StepTimes    times;
  };
} // namespace mpm_granular::Solver

#endif
