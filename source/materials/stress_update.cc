#include <deal.II/base/exceptions.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/selection.h>
#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/stress_update.h>
#include <mpm_granular/points/fetch_ahead.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace mpm_granular::Materials
{
  using namespace dealii;

  namespace
  {
    /// Runs, or parts of them, that together are consecutive points and fit
    /// into StrainIncrements.
    template <int dim>
    struct Batch
    {
      static constexpr unsigned int capacity = StrainIncrements<dim>::capacity;

      Points::Run  range;
      unsigned int first_run;
      unsigned int n_runs = 0;

      /// Of each point the run, counted from the first; whole groups of
      /// Selection.
      std::array<std::uint32_t, capacity + Selection::n> run_of;
    };



    /// Takes the next batch off the front of the runs. It begins with run
    /// @p run, which is not empty, and of which @p n_taken points are in earlier
    /// batches; both are advanced to where the next batch begins.
    template <int dim>
    void
    take_batch(const ArrayView<const Points::Run> runs,
               unsigned int                      &run,
               unsigned int                      &n_taken,
               Batch<dim>                        &batch)
    {
      constexpr unsigned int capacity = Batch<dim>::capacity;
      const unsigned int     begin    = runs[run].begin + n_taken;
      const unsigned int     n_runs   = runs.size();
      batch.first_run                 = run;

      Selection::Entries entries{}; // n times the run
      unsigned int       n = 0;     // points
      do
        {
          // Beyond the run's end this is overwritten for the next one.
          store(entries, &batch.run_of[n]);
          const unsigned int end = std::min(runs[run].end - begin, capacity);
          if (end > n + Selection::n) // rare
            std::fill(&batch.run_of[n + Selection::n],
                      &batch.run_of[end],
                      entries[0]);
          n = end;
          entries += 1;
          n_taken = begin + n - runs[run].begin;
          if (begin + n == runs[run].end)
            {
              ++run;
              n_taken = 0;
            }
      } while (n < capacity && run < n_runs && runs[run].begin == begin + n &&
               runs[run].end > begin + n);
      store(entries - 1, &batch.run_of[n]);
      batch.range  = {begin, begin + n};
      batch.n_runs = entries[0];
    }



    template <int dim>
    void
    check_volumes(const Points::PointArrays<dim> &points,
                  const Batch<dim>               &batch,
                  const StrainIncrements<dim>    &of_runs)
    {
      std::uint64_t n_wrong = 0; // as wide as double, to be vectorized
      for (unsigned int r = 0; r < batch.n_runs; ++r)
        n_wrong += !(of_runs.volume_ratio[r] > 0.);
      if (n_wrong == 0)
        return;

      unsigned int i = 0;
      while (of_runs.volume_ratio[batch.run_of[i]] > 0.)
        ++i;
      const unsigned int index = batch.range.begin + i;
      const double       ratio = of_runs.volume_ratio[batch.run_of[i]];
      std::ostringstream text;
      text << "The volume of point " << points.id[index] << " at ("
           << points.location(index) << ") in cell " << points.cell[index]
           << " would be ";
      if (std::isnan(ratio))
        text << "no number, as the velocity gradient is none.";
      else
        text << "multiplied by " << ratio << " in a step of "
             << of_runs.time_step
             << " s. Try a smaller time step, or look for what makes the "
                "velocity so uneven there.";
      throw ComputationError(text.str());
    }



    template <int dim>
    void
    multiply_volumes(Points::PointArrays<dim>    &points,
                     const Points::Run            range,
                     const StrainIncrements<dim> &increments)
    {
      double *const      volume   = points.volume.data() + range.begin;
      const unsigned int n_points = range.end - range.begin;
      MPM_INDEPENDENT_ITERATIONS
      for (unsigned int i = 0; i < n_points; ++i)
        volume[i] *= increments.volume_ratio[i];
    }
  } // namespace



  template <int dim>
  double
  update_stress(const ConstitutiveLaw<dim>           &law,
                Points::PointArrays<dim>             &points,
                const ArrayView<const Points::Run>    runs,
                const ArrayView<const Tensor<2, dim>> velocity_gradients,
                const double                          time_step)
  {
    AssertDimension(runs.size(), velocity_gradients.size());
    StrainIncrements<dim> of_runs, of_points;
    Batch<dim>            batch;
    double                released_energy = 0.;
    for (unsigned int run = 0, n_taken = 0; run < runs.size();)
      {
        if (runs[run].begin == runs[run].end)
          {
            ++run;
            continue;
          }
        take_batch(runs, run, n_taken, batch);
        of_runs.compute(ArrayView<const Tensor<2, dim>>(
                          &velocity_gradients[batch.first_run], batch.n_runs),
                        time_step);
        check_volumes(points, batch, of_runs);
        const unsigned int n_points   = batch.range.end - batch.range.begin;
        const bool         are_points = batch.n_runs == n_points;
        if (!are_points)
          of_points.spread(of_runs,
                           ArrayView<const std::uint32_t>(batch.run_of.data(),
                                                          n_points));
        const auto &increments = are_points ? of_runs : of_points;
        Points::fetch_ahead(points, batch.range);
        multiply_volumes(points, batch.range, increments);
        released_energy += law.update(points, batch.range, increments);
      }
    return released_energy;
  }

  template double
  update_stress(const ConstitutiveLaw<2> &,
                Points::PointArrays<2> &,
                const ArrayView<const Points::Run>,
                const ArrayView<const Tensor<2, 2>>,
                const double);
  template double
  update_stress(const ConstitutiveLaw<3> &,
                Points::PointArrays<3> &,
                const ArrayView<const Points::Run>,
                const ArrayView<const Tensor<2, 3>>,
                const double);
} // namespace mpm_granular::Materials
