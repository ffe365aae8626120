// What this machine can do at most, to see the figures of the step beside:
//
//   mpirun -np RANKS benchmark_limits
//
// prints one line of JSON: the bandwidth of a triad a = b + s c (24 bytes an
// entry, as STREAM counts) for arrays that do not fit into the caches and for
// arrays that do, and the rate of multiply-adds on registers. All ranks work at
// the same time; the figures are their sums.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <iostream>
#include <vector>

namespace
{
  using namespace dealii;

  /// As many numbers as the processor computes with at once.
#ifdef __AVX512F__
  constexpr unsigned int n_lanes = 8;
#elif defined(__AVX__)
  constexpr unsigned int n_lanes = 4;
#else
  constexpr unsigned int n_lanes = 2;
#endif
  using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

  /// The best of some repetitions, begun together on all ranks [s].
  double
  shortest_time(const std::function<void()> &action)
  {
    constexpr unsigned int n_repetitions = 7;
    double                 best          = 1e300;
    for (unsigned int i = 0; i < n_repetitions; ++i)
      {
        MPI_Barrier(MPI_COMM_WORLD);
        const auto begin = std::chrono::steady_clock::now();
        action();
        const std::chrono::duration<double> taken =
          std::chrono::steady_clock::now() - begin;
        best = std::min(best, taken.count());
      }
    return best;
  }

  /// [bytes/s] of all ranks.
  double
  triad(const std::size_t size)
  {
    const std::size_t   n_passes = std::max<std::size_t>(1, 4000000 / size);
    std::vector<double> a(size, 1.), b(size, 2.), c(size, 3.);
    double             *to   = a.data();
    const double       *from = b.data(), *other = c.data();
    const double        seconds = shortest_time([&] {
      for (std::size_t pass = 0; pass < n_passes; ++pass)
        {
          const double factor = 1. / (1. + pass);
#pragma omp simd
          for (std::size_t i = 0; i < size; ++i)
            to[i] = from[i] + factor * other[i];
          // The compiler may not drop a pass whose result is overwritten.
          asm volatile("" : : "r"(to) : "memory");
        }
    });
    return Utilities::MPI::sum(24. * n_passes * size / seconds, MPI_COMM_WORLD);
  }

  /// [flops/s] of all ranks: x = a x + b in enough registers to hide the
  /// latency.
  double
  peak_flops()
  {
    constexpr unsigned int         n_registers = 12, n_passes = 20000000;
    std::array<Lanes, n_registers> x;
    for (unsigned int r = 0; r < n_registers; ++r)
      x[r] = Lanes{} + 1. + r;
    Lanes a = Lanes{} + 0.999999, b = Lanes{} + 1e-6;
    asm volatile("" : "+m"(a), "+m"(b));
    const double seconds = shortest_time([&] {
      std::array<Lanes, n_registers> y = x;
      for (unsigned int pass = 0; pass < n_passes; ++pass)
        for (auto &lane : y)
          lane = a * lane + b;
      x = y;
    });
    double       sum     = 0.;
    for (const auto &lane : x)
      sum += lane[0];
    asm volatile("" : : "m"(sum));
    return Utilities::MPI::sum(2. * n_registers * n_lanes * n_passes / seconds,
                               MPI_COMM_WORLD);
  }
} // namespace

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const double memory = triad(8000000); // 192 MB a rank
  const double cache  = triad(20000);   // 480 kB a rank
  const double flops  = peak_flops();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "{\"memory_bandwidth\": " << memory
              << ", \"cache_bandwidth\": " << cache
              << ", \"peak_flops\": " << flops << ", \"lanes\": " << n_lanes
              << "}" << std::endl;
}
