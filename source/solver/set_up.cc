// Setting up a computation: what happens once, before the first step.

#include <mpm_granular/solver/mpm_solver.h>
#include <mpm_granular/time/critical_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace mpm_granular::Solver
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Laws = std::vector<const Materials::ConstitutiveLaw<dim> *>;

    template <int dim>
    Laws<dim>
    laws_of(const RunParameters<dim> &parameters)
    {
      Laws<dim> laws;
      for (const auto &name : parameters.materials.all_names())
        laws.push_back(&*parameters.materials[name].law);
      return laws;
    }

    /// Names of the history slots of the laws; laws that name one slot
    /// differently share it.
    template <int dim>
    std::vector<std::string>
    history_names(const Laws<dim> &laws)
    {
      std::vector<std::string> names;
      for (const auto *law : laws)
        {
          const auto of_law = law->history_names();
          for (unsigned int slot = 0; slot < of_law.size(); ++slot)
            if (slot == names.size())
              names.push_back(of_law[slot]);
            else if (names[slot] != of_law[slot])
              names[slot] += "_or_" + of_law[slot];
        }
      return names;
    }

    /// Those of the laws, then those of the velocity update, then the others.
    template <int dim>
    std::vector<std::string>
    history_names(const Laws<dim> &laws, const RunParameters<dim> &parameters)
    {
      auto names = history_names<dim>(laws);
      for (const auto &of_transfer :
           {parameters.velocity_update->history_names(),
            Transfer::SettledPressures<dim>::history_names(
              parameters.equilibrium.is_wanted)})
        names.insert(names.end(), of_transfer.begin(), of_transfer.end());
      return names;
    }

    template <int dim>
    double
    least_density(const Laws<dim> &laws)
    {
      double density = std::numeric_limits<double>::max();
      for (const auto *law : laws)
        density = std::min(density, law->density());
      return density;
    }
  } // namespace

  template <int dim>
  MPMSolver<dim>::MPMSolver(const RunParameters<dim> &parameters,
                            const std::string        &input_file,
                            const MPI_Comm            communicator)
    : parameters(parameters)
    , mesh(*parameters.mesh, input_file, communicator)
    , partition(parameters.partition,
                mesh,
                communicator,
                parameters.averaging->reaches_beyond_cells())
    , adaptation(parameters.adaptation)
    , laws(laws_of(parameters))
    , points(mesh, partition, history_names<dim>(laws, parameters))
    , fields(mesh, partition)
    , boundary(parameters.boundary_conditions, mesh, communicator)
    , momentum(parameters.momentum, mesh, least_density<dim>(laws))
    , averaging(*parameters.averaging)
    , velocity_update(*parameters.velocity_update)
    , step_control(parameters.time_step)
    , settled_pressures(mesh,
                        history_names<dim>(laws).size() +
                          velocity_update.history_names().size(),
                        parameters.equilibrium.is_wanted)
    , sweep(mesh,
            partition,
            laws,
            averaging,
            velocity_update,
            settled_pressures)
  {
    averaging.reinit(mesh, partition, largest_specific_volumes());
    velocity_update.set_first_slot(history_names<dim>(laws).size());
    check_contact();
    create_points_on_adapted_mesh(input_file);
    choose_scheme();
    set_initial_state();
    if (parameters.equilibrium.is_wanted)
      prepare_settling();
    find_cell_limits();
    find_cell_sizes();
    if (partition.n_ranks > 1)
      redistribute();
    else
      project();
    agree_on_state();
    step_control.check_stability(step_limits().critical_step);
  }

  template <int dim>
  void
  MPMSolver<dim>::check_contact() const
  {
    if (!boundary.has_contact())
      return;
    const std::string wall = "A wall with 'Type = Coulomb friction' ";
    require(parameters.momentum.mass_matrix->handles_contact(),
            wall + "needs Scheme/Mass matrix = lumped.");
    // The velocity before the balance does not tell which walls push.
    require(parameters.transfer.stress_order() !=
              Transfer::StressOrder::update_stress_first,
            wall + "needs Scheme/Stress order = MUSL or USL, not USF.");
    require(velocity_update.handles_contact(),
            wall + "needs another Scheme/Velocity update than " +
              parameters.velocity_update.chosen_name() + ".");
  }

  template <int dim>
  void
  MPMSolver<dim>::create_points(const std::string &input_file)
  {
    const auto &materials = parameters.materials.all_names();
    const auto &regions   = parameters.regions.all_names();

    for (unsigned int r = 0; r < regions.size(); ++r)
      {
        const auto                    &region = parameters.regions[regions[r]];
        std::vector<Points::Seed<dim>> seeds;
        try
          {
            seeds = region.fill(mesh, input_file);
          }
        catch (const InputError &error)
          {
            throw InputError("Points/" + regions[r] + ": " + error.what());
          }
        for (unsigned int before = 0; before < r; ++before)
          for (const auto &seed : seeds)
            if (parameters.regions[regions[before]].contains(seed.position,
                                                             seed.cell))
              throw InputError("The regions " + regions[before] + " and " +
                               regions[r] +
                               " of 'Points' overlap, for example at " +
                               Mesh::as_text(seed.position) + ".");
        const unsigned int material = std::find(materials.begin(),
                                                materials.end(),
                                                region.material_name()) -
                                      materials.begin();
        points.insert(seeds, material, laws[material]->density());
      }
    points.load();
  }

  template <int dim>
  void
  MPMSolver<dim>::choose_scheme()
  {
    // Points are in the order of their cells, each at the owner of the cell.
    const auto &arrays = points.arrays();
    double sums[] = {double(arrays.size()), 0., 0.}; // points, cells, volume
    for (unsigned int p = 0; p < arrays.size(); ++p)
      if (p == 0 || arrays.cell[p] != arrays.cell[p - 1])
        {
          sums[1] += 1.;
          sums[2] += mesh.cell_volume(arrays.cell[p]);
        }
    Utilities::MPI::sum(sums, partition.communicator, sums);
    const auto &[n_points, n_cells, volume] = sums;
    double largest_speed                    = 0.;
    for (const auto *law : laws)
      if (law->has_smoothable_pressure())
        largest_speed = std::max(largest_speed, law->wave_speed());
    const bool is_granular = largest_speed > 0.;
    if (averaging.suit(
          {n_points / n_cells, is_granular, parameters.equilibrium.is_wanted}))
      averaging.reinit(mesh, partition, largest_specific_volumes());

    const double size = mesh.size_of_cell(volume / n_cells);
    scheme.averaging =
      averaging.name_in_use(parameters.averaging.chosen_name());
    scheme.filter_rate = parameters.transfer.filter_rate(
      averaging.suitable_filter_rate() * largest_speed / size);
    scheme.shift_rate =
      parameters.position_shift.rate(averaging.suitable_shift_rate());
  }

  template <int dim>
  void
  MPMSolver<dim>::set_initial_state()
  {
    auto       &arrays  = points.arrays();
    const auto  gravity = parameters.body_force.gravity_at(0.);
    std::string remark;

    // Small against what a point stands for, large against round-off.
    constexpr double small           = 1e-3;
    const bool       keeps_gradients = !velocity_update.history_names().empty();
    for (unsigned int p = 0; p < arrays.size(); ++p)
      {
        const auto &law = *laws[arrays.material[p]];
        parameters.initial_state.apply(arrays, p, law.density(), gravity);
        law.initialize(arrays, {p, p + 1});
        if (keeps_gradients)
          velocity_update.initialize(arrays,
                                     p,
                                     parameters.initial_state.velocity_gradient(
                                       arrays.location(p),
                                       small *
                                         std::pow(arrays.volume[p], 1. / dim)));
        double speed = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          speed += std::abs(arrays.velocity[d][p]);
        require(!parameters.equilibrium.is_wanted || speed == 0.,
                "Initial state/Velocity must be zero, as it is after 'Initial "
                "equilibrium'; at " +
                  Mesh::as_text(arrays.location(p)) + " it is not.");
        if (remark.empty())
          {
            Stress<dim> stress;
            for (unsigned int s = 0; s < n_stress<dim>; ++s)
              stress[s] = arrays.stress[s][p];
            remark = law.remark_on(stress);
            if (!remark.empty())
              remarks.push_back("Initial stress at " +
                                Mesh::as_text(arrays.location(p)) + ": " +
                                remark);
          }
      }
  }

  template <int dim>
  std::vector<double>
  MPMSolver<dim>::largest_specific_volumes() const
  {
    std::vector<double> volumes;
    for (const auto *law : laws)
      volumes.push_back(law->forms_gaps() ?
                          1. / law->density() :
                          std::numeric_limits<double>::infinity());
    return volumes;
  }

  template <int dim>
  void
  MPMSolver<dim>::find_cell_limits()
  {
    // Any material may come to any cell. Many cells may have the same shape up
    // to round-off: the limit is that of the gradients rounded to a part in
    // 2^24 of the largest, so that it is the same wherever it is computed.
    constexpr double parts = 1 << 24;
    const double factor = parameters.momentum.mass_matrix->time_step_factor();
    cell_limits.resize(mesh.n_cells());
    mesh.visit([&](const auto &cells) {
      using Cell  = typename std::decay_t<decltype(cells)>::value_type;
      using Shape = std::array<double, dim * dim>;
      std::map<Shape, double> step_of_shape;
      for (unsigned int index = 0; index < cells.size(); ++index)
        {
          float largest = 0.;
          for (const auto &gradient : cells[index].gradient)
            for (const double component : gradient)
              largest = std::max<float>(largest, std::abs(component));
          Shape shape;
          Cell  rounded = cells[index];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              rounded.gradient[i][j] = shape[i * dim + j] =
                std::round(cells[index].gradient[i][j] / largest * parts) *
                largest / parts;
          auto &step = step_of_shape[shape];
          if (step == 0.)
            {
              step = std::numeric_limits<double>::max();
              for (const auto *law : laws)
                step =
                  std::min(step,
                           factor * Time::critical_step(rounded,
                                                        {law->bulk_modulus(),
                                                         law->shear_modulus(),
                                                         law->density()}));
            }
          cell_limits[index] = {step, mesh.altitude(index)};
        }
    });
  }

  template <int dim>
  void
  MPMSolver<dim>::find_cell_sizes()
  {
    if (scheme.shift_rate == 0.)
      return;
    cell_sizes.resize(mesh.n_cells());
    for (unsigned int cell = 0; cell < cell_sizes.size(); ++cell)
      cell_sizes[cell] = mesh.size_of_cell(mesh.cell_volume(cell));
  }

  template class MPMSolver<2>;
  template class MPMSolver<3>;
} // namespace mpm_granular::Solver
