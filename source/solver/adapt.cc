// The mesh follows the flow (section 9 of doc/theory.md): as the points carry
// all state, it may become another one between two steps.

#include <deal.II/base/timer.h>

#include <mpm_granular/adaptivity/state.h>
#include <mpm_granular/materials/merging.h>
#include <mpm_granular/solver/mpm_solver.h>

namespace mpm_granular::Solver
{
  using namespace dealii;

  template <int dim>
  std::vector<std::uint8_t>
  MPMSolver<dim>::wanted_levels()
  {
    fields.gather_nodes();
    const Adaptivity::State<dim> state(
      mesh, partition, fields, points.count_by_cell(), current_time);
    return adaptation.wanted_levels(state);
  }

  template <int dim>
  void
  MPMSolver<dim>::create_points_on_adapted_mesh(const std::string &input_file)
  {
    create_points(input_file);
    if (!adaptation.is_active())
      return;
    // How many points there are in a cell follows from the mesh: each new one
    // is filled anew, until it suits its points.
    for (unsigned int level = 0; level <= parameters.adaptation.maximum_level;
         ++level)
      {
        project();
        if (!mesh.adapt(wanted_levels()))
          break;
        points.clear();
        partition.distribute(std::vector<std::uint32_t>(mesh.n_cells(), 1));
        reinit_on_mesh();
        create_points(input_file);
      }
  }

  template <int dim>
  void
  MPMSolver<dim>::adapt_mesh()
  {
    if (!adaptation.is_due(n_steps - last_adaptation,
                           displacement / mesh.mean_cell_size()))
      return;
    const Timer timer;
    points.release();
    points.send_home();
    project();
    bool has_changed = false;
    for (unsigned int level = 0; level <= parameters.adaptation.maximum_level;
         ++level)
      {
        if (!adapt_mesh_once())
          break;
        has_changed = true;
      }
    split_and_merge();
    changes.n_adaptations += has_changed;
    changes.n_limited += adaptation.is_limited();
    last_adaptation = n_steps;
    displacement    = 0.;
    agree_on_state(requests());
    changes.seconds += timer.wall_time();
  }

  template <int dim>
  bool
  MPMSolver<dim>::adapt_mesh_once()
  {
    const auto wanted = wanted_levels();
    points.pull_inside();
    const auto new_cells = mesh.adapt(wanted);
    if (!new_cells)
      return false;
    points.follow(*new_cells);
    const auto n_points = points.count_by_cell();
    points.release();
    partition.distribute(n_points);
    reinit_on_mesh();
    points.send_home();
    project();
    return true;
  }

  template <int dim>
  void
  MPMSolver<dim>::split_and_merge()
  {
    const unsigned int least = parameters.adaptation.split_below,
                       most  = parameters.adaptation.merge_above;
    if (least > 0)
      points.split(least);
    if (most > 0)
      {
        const auto loss = Materials::merge(points.arrays(), laws, most);
        ledger.transfer_loss +=
          parameters.momentum.mass_scaling * loss.kinetic + loss.elastic;
      }
    if (least > 0 || most > 0)
      project();
  }

  template <int dim>
  void
  MPMSolver<dim>::serialize_mesh(Core::Archive &archive)
  {
    if (!adaptation.is_active())
      return;
    std::vector<std::uint8_t> tree = mesh.refinement_tree();
    archive.replicated("mesh/levels", tree);
    archive.replicated("mesh/last_adaptation", last_adaptation);
    archive.replicated("mesh/displacement", displacement);
    archive.replicated("mesh/n_adaptations", changes.n_adaptations);
    archive.replicated("mesh/n_limited", changes.n_limited);
    archive.replicated("mesh/seconds", changes.seconds);
    if (!archive.is_reading())
      return;
    points.clear();
    mesh.set_refinement_tree(tree);
    partition.distribute(std::vector<std::uint32_t>(mesh.n_cells(), 1));
    reinit_on_mesh();
  }

  template class MPMSolver<2>;
  template class MPMSolver<3>;
} // namespace mpm_granular::Solver
