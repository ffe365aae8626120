#include <deal.II/base/exceptions.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/stress_update.h>
#include <mpm_granular/points/fetch_ahead.h>

#include <algorithm>
#include <cmath>
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

      Points::Run                       range;
      std::array<Points::Run, capacity> pieces;
      unsigned int                      n_pieces  = 0;
      unsigned int                      first_run = 0;
    };



    /// Takes the next batch off the front of the runs. It begins with run
    /// @p run, of which @p n_taken points are in earlier batches; both are
    /// advanced to where the next batch begins.
    template <int dim>
    Batch<dim>
    next_batch(const ArrayView<const Points::Run> runs,
               unsigned int                      &run,
               unsigned int                      &n_taken)
    {
      Batch<dim>         batch;
      const unsigned int begin = runs[run].begin + n_taken;
      const unsigned int limit = begin + Batch<dim>::capacity;
      batch.range              = {begin, begin};
      batch.first_run          = run;
      while (run < runs.size() && batch.n_pieces < Batch<dim>::capacity &&
             batch.range.end < limit &&
             runs[run].begin + n_taken == batch.range.end)
        {
          const unsigned int end         = std::min(runs[run].end, limit);
          batch.pieces[batch.n_pieces++] = {batch.range.end, end};
          batch.range.end                = end;
          if (end < runs[run].end)
            {
              n_taken = end - runs[run].begin;
              break;
            }
          ++run;
          n_taken = 0;
        }
      return batch;
    }



    template <int dim>
    void
    check_volumes(const Points::PointArrays<dim> &points,
                  const Batch<dim>               &batch,
                  const StrainIncrements<dim>    &of_runs)
    {
      for (unsigned int r = 0; r < batch.n_pieces; ++r)
        if (!(of_runs.volume_ratio[r] > 0.))
          {
            const unsigned int index = batch.pieces[r].begin;
            const double       ratio = of_runs.volume_ratio[r];
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
    double                released_energy = 0.;
    for (unsigned int run = 0, n_taken = 0; run < runs.size();)
      {
        const Batch<dim> batch = next_batch<dim>(runs, run, n_taken);
        of_runs.compute(ArrayView<const Tensor<2, dim>>(
                          &velocity_gradients[batch.first_run], batch.n_pieces),
                        time_step);
        check_volumes(points, batch, of_runs);
        const bool are_points =
          batch.n_pieces == batch.range.end - batch.range.begin;
        if (!are_points)
          of_points.spread(of_runs,
                           ArrayView<const Points::Run>(batch.pieces.data(),
                                                        batch.n_pieces));
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
