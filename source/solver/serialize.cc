#include <mpm_granular/mesh/fingerprint.h>
#include <mpm_granular/solver/mpm_solver.h>

#include <numeric>

/*
 * The part of MPMSolver that writes its state to checkpoints and reads it.
 */
namespace mpm_granular::Solver
{
  using namespace dealii;

  namespace
  {
    /// A number of each rank. Read on other ranks than those that wrote it, all
    /// of them together still have the same sum.
    template <class Number>
    void
    serialize_summed(Core::Archive     &archive,
                     const std::string &name,
                     Number            &number)
    {
      std::vector<Number> rows{number};
      archive.distributed("ranks/" + name, rows);
      number = std::accumulate(rows.begin(), rows.end(), Number(0));
    }
  } // namespace

  template <int dim>
  void
  MPMSolver<dim>::serialize(Core::Archive &archive)
  {
    serialize_mesh(archive);
    const std::uint64_t fingerprint_now =
      Mesh::fingerprint(mesh, partition.communicator);
    std::uint64_t fingerprint = fingerprint_now;
    archive.replicated("mesh/fingerprint", fingerprint);
    require(
      fingerprint == fingerprint_now,
      "The mesh is not the one the checkpoint was written with; has the "
      "mesh file changed, or the version of the program, which numbers the "
      "cells? A run can only go on with its own mesh.");

    archive.replicated("solver/time", current_time);
    archive.replicated("solver/time_step", last_time_step);
    archive.replicated("solver/since_filter", since_filter);
    archive.replicated("solver/n_steps", n_steps);
    archive.replicated("solver/last_balance", last_balance);
    archive.replicated("load/n_redistributions", load.n_redistributions);
    archive.replicated("load/n_migrations", load.n_migrations);
    archive.replicated("load/seconds", load.seconds);
    archive.replicated("load/largest_imbalance", load.largest_imbalance);
    step_control.serialize(archive);
    serialize_summed(archive, "n_lost", n_lost);
    serialize_summed(archive, "dissipated", ledger.dissipated);
    serialize_summed(archive, "boundary_work", ledger.boundary_work);
    serialize_summed(archive, "transfer_loss", ledger.transfer_loss);
    serialize_summed(archive, "filter_loss", ledger.filter_loss);
    serialize_summed(archive, "damping", ledger.damping);
    points.release();
    points.serialize(archive);

    if (archive.has_same_ranks())
      {
        partition.serialize(archive);
        if (archive.is_reading())
          reinit_on_mesh();
        points.attach();
        fields.serialize(archive);
        averaging.serialize(archive);
        serialize_summed(archive, "kinetic_energy", motion.kinetic_energy);
        serialize_summed(archive, "speed_squared", motion.speed_squared);
        serialize_summed(archive, "n_runs", n_runs);
        archive.replicated("solver/n_runs_in_order", n_runs_in_order);
      }
    else
      {
        points.send_home();
        redistribute();
      }
    if (archive.is_reading())
      agree_on_state();
  }

  template class MPMSolver<2>;
  template class MPMSolver<3>;
} // namespace mpm_granular::Solver
