// Times the step of a case while the points are in motion:
//
//   mpirun -np RANKS benchmark_step INPUT.prm [--from TIME] [--steps N]
//     [--repeat N] [--scalar] [--set SECTION/ENTRY=VALUE ...]
//
// advances the case to TIME [s], then times N steps, several times. Prints one
// JSON object: times, counts, bytes; of the single steps, sharing out aside,
// the slowest over the median. With --scalar (3D simplices, one rank) a plain
// scalar loop (scalar_step.h) advances copies of the same points by the same
// steps, in turn with the program, and the results are compared.

#include <deal.II/base/mpi.h>

#include "counted.h"
#include "scalar_step.h"

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/exit_code.h>
#include <mpm_granular/materials/drucker_prager_parameters.h>
#include <mpm_granular/output/json.h>
#include <mpm_granular/parameters/dimension.h>
#include <mpm_granular/parameters/parameter_file.h>
#include <mpm_granular/solver/mpm_solver.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mpm_granular::Benchmarks
{
  using namespace dealii;

  struct Options
  {
    std::string              input;
    std::vector<std::string> overrides;
    double                   from      = 0.; ///< [s]
    unsigned int             n_steps   = 20;
    unsigned int             n_repeats = 5;
    bool                     scalar    = false;
  };

  Options
  parse(const int argc, char **argv)
  {
    Options options;
    for (int i = 1; i < argc; ++i)
      {
        const std::string word  = argv[i];
        const auto        value = [&] {
          require(++i < argc, word + " needs a value.");
          return std::string(argv[i]);
        };
        if (word == "--set")
          options.overrides.push_back(value());
        else if (word == "--from")
          options.from = std::stod(value());
        else if (word == "--steps")
          options.n_steps = std::stoul(value());
        else if (word == "--repeat")
          options.n_repeats = std::stoul(value());
        else if (word == "--scalar")
          options.scalar = true;
        else if (options.input.empty())
          options.input = word;
        else
          require(false, "What is " + word + "?");
      }
    require(!options.input.empty(), "Which input?");
    return options;
  }

  /// Wall time that an action takes on the slowest rank [s].
  template <class Action>
  double
  seconds_for(Action &&action)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    const auto begin = std::chrono::steady_clock::now();
    action();
    const std::chrono::duration<double> taken =
      std::chrono::steady_clock::now() - begin;
    return Utilities::MPI::max(taken.count(), MPI_COMM_WORLD);
  }

  double
  median(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }

  template <class Array>
  std::size_t
  size_of_entry(const Array &)
  {
    return sizeof(typename Array::value_type);
  }

  /**
   * Bytes that a step at least reads and writes, per point: every array of the
   * points once, what it changes of them once more (position, velocity, stress,
   * volume, history), the geometry of a cell twice (points, nodes), its sums
   * four times (written; read for the nodes, for the re-mapped momentum; added
   * to in the cache), what nodes give and take once in each direction.
   */
  template <int dim>
  double
  bytes_per_point(const Solver::MPMSolver<dim> &solver)
  {
    const auto &points = solver.material_points().arrays();
    const auto &fields = solver.nodal_fields();
    std::size_t read = 0, written = 0;
    const_cast<Points::PointArrays<dim> &>(points).for_each_array(
      [&](const auto &array) { read += size_of_entry(array); });
    read -= size_of_entry(points.id);
    for (const auto &array : points.position)
      written += size_of_entry(array);
    for (const auto &array : points.velocity)
      written += size_of_entry(array);
    for (const auto &array : points.stress)
      written += size_of_entry(array);
    for (const auto &array : points.history)
      written += size_of_entry(array);
    written += size_of_entry(points.volume);
    const std::size_t of_cell =
      solver.background_mesh().visit([&](const auto &cells) {
        using Cell = typename std::decay_t<decltype(cells)>::value_type;
        return 2 * sizeof(Cell) + 4 * sizeof(Grid::CellSums<Cell>) +
               3 * Cell::n_nodes * sizeof(unsigned int);
      });
    const std::size_t of_node = 2 * sizeof(Grid::NodeSums<dim>) +
                                2 * sizeof(Grid::NodeMotion<dim>) +
                                5 * 2 * sizeof(Tensor<1, dim>);
    return read + written +
           double(of_cell * fields.active_cells.size() +
                  of_node * fields.n_active_nodes()) /
             points.size();
  }

  /// The case of the scalar loop, from the entries of the parameter file.
  ScalarCase
  scalar_case(const Solver::RunParameters<3>       &parameters,
              const std::vector<Parameters::Entry> &entries,
              const Solver::MPMSolver<3>           &solver)
  {
    const auto value = [&](const std::string &path) {
      const auto *entry = Parameters::find_entry(entries, path);
      require(entry != nullptr,
              "The scalar loop needs the entry " + path + ".");
      return entry->value;
    };
    const auto number = [&](const std::string &path) {
      return std::stod(value(path));
    };
    const std::string material =
      "Materials/" + parameters.materials.all_names()[0] + "/";
    require(value(material + "Law") == "Drucker-Prager viscoplastic" &&
              number(material + "Perzyna exponent") == 1. &&
              value(material + "Separation") == "track" &&
              value("Scheme/Stress order") == "MUSL" &&
              value("Scheme/Velocity update") == "blend" &&
              value("Scheme/Mass matrix") == "lumped" &&
              value("Scheme/Averaging") == "none" &&
              number("Scheme/Pressure filter rate") == 0.,
            "The scalar loop has no other law or scheme than those of "
            "prm/wall.prm, without pressure filter.");

    const auto &law  = *solver.material_laws()[0];
    const auto &mesh = solver.background_mesh();
    ScalarCase  result{law.bulk_modulus(),
                      law.shear_modulus(),
                      Materials::slope_of_cone(value(material + "Cone slope"),
                                               number(material +
                                                      "Friction angle")),
                      number(material + "Fluidity"),
                      -parameters.body_force.gravity_at(0.)[2],
                      number("Scheme/PIC rate"),
                      number("Scheme/Mass cut-off") * law.density(),
                      std::vector<unsigned char>(mesh.n_nodes(), 0)};
    for (const auto &face : mesh.boundary_faces())
      for (const unsigned int node : face.node)
        {
          for (unsigned int d = 0; d < 2; ++d)
            if (std::abs(face.normal[d]) > .5)
              result.held[node] |= 1 << d; // rollers
          if (face.normal[2] < -.5)
            result.held[node] = 7; // the clamped base
        }
    return result;
  }

  template <class Number>
  std::vector<typename ScalarStep<Number>::Point>
  copy_points(const Points::PointArrays<3> &points)
  {
    std::vector<typename ScalarStep<Number>::Point> copies(points.size());
    for (unsigned int p = 0; p < copies.size(); ++p)
      {
        auto &copy = copies[p];
        for (unsigned int d = 0; d < 3; ++d)
          {
            copy.x[d] = points.position[d][p];
            copy.v[d] = points.velocity[d][p];
          }
        for (unsigned int s = 0; s < 6; ++s)
          copy.stress[s] = points.stress[s][p];
        copy.mass             = points.mass[p];
        copy.volume           = points.volume[p];
        copy.strain           = points.history[0][p];
        copy.log_volume_ratio = points.history[1][p];
        copy.cell             = points.cell[p];
      }
    return copies;
  }

  /// What must agree, of points in any order: sums over the points.
  std::array<double, 4>
  sums_of(const std::vector<ScalarStep<double>::Point> &points)
  {
    std::array<double, 4> sums{};
    for (const auto &point : points)
      {
        sums[0] += point.x[0] * point.x[0] + point.x[2] * point.x[2];
        sums[1] +=
          point.mass * (point.v[0] * point.v[0] + point.v[1] * point.v[1] +
                        point.v[2] * point.v[2]);
        sums[2] += point.stress[2] * point.stress[2];
        sums[3] += point.strain;
      }
    return sums;
  }

  template <int dim>
  void
  run(const Options &options)
  {
    Solver::RunParameters<dim> parameters;
    const auto                 entries =
      Parameters::read(parameters, options.input, options.overrides);
    Parameters::check(parameters, options.input);

    std::unique_ptr<Solver::MPMSolver<dim>> solver;
    const double                            set_up = seconds_for([&] {
      solver = std::make_unique<Solver::MPMSolver<dim>>(parameters,
                                                        options.input,
                                                        MPI_COMM_WORLD);
    });
    // The last steps before an event would be even shorter.
    const double never = options.from + 1e3;
    while (solver->time() < options.from)
      solver->advance_one_step(never);

    std::unique_ptr<ScalarCase>         given;
    std::unique_ptr<ScalarStep<double>> scalar;
    double                              flops = 0.;
    if constexpr (dim == 3)
      if (options.scalar)
        {
          const auto &mesh   = solver->background_mesh();
          const auto &points = solver->material_points().arrays();
          given              = std::make_unique<ScalarCase>(
            scalar_case(parameters, entries, *solver));
          ScalarStep<Counted> counting(mesh,
                                       *given,
                                       copy_points<Counted>(points));
          Counted::n_operations = 0;
          counting.advance(solver->time_step());
          flops = double(Counted::n_operations) / points.size();
          scalar =
            std::make_unique<ScalarStep<double>>(mesh,
                                                 *given,
                                                 copy_points<double>(points));
        }

    const auto         &times  = solver->step_times();
    const auto          before = times;
    std::vector<double> ours, plain, steps, seconds;
    std::uint64_t       n_point_steps = 0;
    for (unsigned int repeat = 0; repeat < options.n_repeats; ++repeat)
      {
        steps.clear();
        std::uint64_t n_now = 0;
        ours.push_back(seconds_for([&] {
          for (unsigned int step = 0; step < options.n_steps; ++step)
            {
              const unsigned int n_moves = solver->load_balance().n_migrations;
              const auto         begin   = std::chrono::steady_clock::now();
              solver->advance_one_step(never);
              const std::chrono::duration<double> taken =
                std::chrono::steady_clock::now() - begin;
              if (solver->load_balance().n_migrations == n_moves)
                seconds.push_back(taken.count());
              steps.push_back(solver->time_step());
              n_now += solver->n_points();
            }
        }));
        ours.back() /= n_now;
        n_point_steps += n_now;
        if (scalar)
          {
            plain.push_back(seconds_for([&] {
              for (const double step : steps)
                scalar->advance(step);
            }));
            plain.back() /= n_now;
          }
      }

    const auto summed = [](const auto value) {
      return Utilities::MPI::sum(value, MPI_COMM_WORLD);
    };
    const auto        &points = solver->material_points().arrays();
    Output::JsonObject parts;
    for (unsigned int part = 0; part < times.names.size(); ++part)
      parts.add(times.names[part],
                1e9 *
                  Utilities::MPI::max(times.seconds[part] -
                                        before.seconds[part],
                                      MPI_COMM_WORLD) /
                  n_point_steps);
    Output::JsonObject result;
    result.add("dimension", dim)
      .add("ranks", Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD))
      .add("points", solver->n_points())
      .add("cells", solver->background_mesh().n_global_cells())
      .add("filled_cells",
           summed(std::uint64_t(solver->nodal_fields().active_cells.size())))
      .add("time", solver->time())
      .add("set_up_seconds", set_up)
      .add("ns_per_point_step", 1e9 * median(ours))
      .add("ns_least", 1e9 * *std::min_element(ours.begin(), ours.end()))
      .add("ns_most", 1e9 * *std::max_element(ours.begin(), ours.end()))
      .add("steps", seconds.size())
      .add("slowest_over_median_step",
           *std::max_element(seconds.begin(), seconds.end()) / median(seconds))
      .add("parts", parts)
      .add("bytes_per_point_step",
           summed(bytes_per_point(*solver) * points.size()) /
             solver->n_points())
      .add("memory_per_point",
           summed(double(solver->material_points().memory_consumption())) /
             solver->n_points())
      .add("memory_in_all_per_point",
           summed(double(solver->memory_consumption())) / solver->n_points());
    if constexpr (dim == 3)
      if (scalar)
        {
          std::vector<double> ratios;
          for (unsigned int i = 0; i < ours.size(); ++i)
            ratios.push_back(plain[i] / ours[i]);
          const auto sums      = sums_of(copy_points<double>(points)),
                     reference = sums_of(scalar->points);
          double difference    = 0.;
          for (unsigned int i = 0; i < sums.size(); ++i)
            difference =
              std::max(difference, std::abs(sums[i] / reference[i] - 1.));
          result.add("scalar_ns_per_point_step", 1e9 * median(plain))
            .add("ratio_to_scalar", median(ratios))
            .add("difference_to_scalar", difference)
            .add("flops_per_point_step", flops);
        }
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << result.text() << std::endl;
  }
} // namespace mpm_granular::Benchmarks

int
main(int argc, char **argv)
{
  using namespace mpm_granular;
  int                                            n_seen   = 1;
  char                                          *seen[]   = {argv[0], nullptr};
  char                                         **pointers = seen;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_seen, pointers, 1);
  return static_cast<int>(Core::run_and_report([&] {
    const auto options = Benchmarks::parse(argc, argv);
    if (Parameters::read_dimension(options.input, options.overrides) == 2)
      Benchmarks::run<2>(options);
    else
      Benchmarks::run<3>(options);
    return Core::ExitCode::done;
  }));
}
