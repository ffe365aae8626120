// Guards the speed of the time step: counts its instructions per point, by
// letting the processor stop after each (ptrace), and compares with what they
// were. Times would differ from run to run; counters of the processor are not
// everywhere, and neither does valgrind know all of its instructions.
//
// A number below is no truth but what was counted when it was last renewed, for
// one compiler and kind of processor; elsewhere nothing is compared. Where the
// step has to do more, or does less, put the numbers that this program prints
// when it gets any argument into the table, in the same commit. Where points
// are now ordered in the step that is counted, choose another one.

#include <deal.II/base/mpi.h>

#include <sched.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <mpm_granular/parameters/parameter_file.h>
#include <mpm_granular/solver/mpm_solver.h>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace mpm_granular;

struct Case
{
  std::string              name;
  std::vector<std::string> settings; ///< of prm/wall_hexahedra.prm
  double                   known;    ///< instructions per point and step
};

// For g++ 12 with -march=native on AMD's processors that have AVX-512.
#if defined(__znver3__) && defined(__AVX512F__) && !defined(__clang__)
constexpr bool is_known = __GNUC__ == 12;
#else
constexpr bool is_known = false;
#endif

const std::vector<Case> cases = {{"tetrahedra",
                                  {"Mesh/Cells=simplices",
                                   "Points/wall/Points per cell=4"},
                                  446.},
                                 {"cubes", {}, 1218.}};

constexpr int          refused        = 77; // exit code: no ptrace
constexpr double       allowed_growth = .05;
constexpr unsigned int n_before = 40, n_counted = 1; // steps

/// Runs a small wall in motion; stops itself before and after the steps that
/// are to be counted.
/// @return the number of points.
unsigned int
advance(const Case &current)
{
  auto settings = current.settings;
  settings.insert(settings.end(),
                  {"Mesh/Subdivisions=8, 1, 4",
                   "Initial state/Velocity=1.2*x; 0; -1.2*z",
                   "Scheme/Pressure filter rate=0",
                   "Scheme/Averaging=none"});
  const std::string        input = SOURCE_DIR "/../../prm/wall_hexahedra.prm";
  Solver::RunParameters<3> parameters;
  Parameters::read(parameters, input, settings);
  Parameters::check(parameters, input);
  Solver::MPMSolver<3> solver(parameters, input, MPI_COMM_WORLD);
  const double         never = 1e3;
  for (unsigned int step = 0; step < n_before; ++step)
    solver.advance_one_step(never);
  std::raise(SIGSTOP);
  for (unsigned int step = 0; step < n_counted; ++step)
    solver.advance_one_step(never);
  std::raise(SIGSTOP);
  return solver.n_points();
}

/// Counts the instructions of a child between its two stops.
/// @return 0 if that is not allowed here; infinity if the child has failed.
double
count(const pid_t child)
{
  std::uint64_t n_instructions = 0;
  unsigned int  n_stops        = 0;
  int           status         = 0;
  while (waitpid(child, &status, 0) == child && WIFSTOPPED(status))
    {
      int signal = WSTOPSIG(status);
      if (signal == SIGSTOP)
        ++n_stops;
      if (signal == SIGTRAP)
        ++n_instructions;
      if (signal == SIGSTOP || signal == SIGTRAP)
        signal = 0;
      ptrace(n_stops == 1 ? PTRACE_SINGLESTEP : PTRACE_CONT, child, 0, signal);
    }
  if (WIFEXITED(status) && WEXITSTATUS(status) == refused)
    return 0.;
  const bool is_done =
    n_stops == 2 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return is_done ? n_instructions : std::numeric_limits<double>::infinity();
}

/// Instructions per point and step.
double
count(const Case &current)
{
  int to_parent[2];
  if (pipe(to_parent) != 0)
    return 0.;
  // Parent and child take turns: on one core they need not wake up another.
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof(one), &one);
  const pid_t child = fork();
  if (child == 0)
    {
      if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
        _exit(refused);
      int                                            n_seen = 0;
      char                                         **seen   = nullptr;
      const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_seen, seen, 1);
      const unsigned int n_points = advance(current);
      const bool         is_written =
        write(to_parent[1], &n_points, sizeof(n_points)) == sizeof(n_points);
      return is_written ? -1. : -2.; // ends as this program does
    }
  const double n_instructions = count(child);
  unsigned int n_points       = 0;
  close(to_parent[1]);
  if (read(to_parent[0], &n_points, sizeof(n_points)) != sizeof(n_points))
    return n_instructions;
  return n_instructions / n_points / n_counted;
}

/// With an argument, prints all numbers.
int
main(int argc, char **)
{
  for (const auto &current : cases)
    {
      const double counted = count(current);
      if (counted < 0.)
        return counted == -1. ? 0 : 1; // this is the child
      const bool is_more =
        !std::isfinite(counted) ||
        (is_known && counted > (1. + allowed_growth) * current.known);
      std::cout << current.name << ": "
                << (is_more ? "more instructions than before" : "as before")
                << std::endl;
      if (is_more || argc > 1)
        std::cout << counted << " per point and step, before: " << current.known
                  << std::endl;
    }
}
