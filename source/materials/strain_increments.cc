#include <deal.II/base/exceptions.h>

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/core/selection.h>
#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/strain_increments.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mpm_granular::Materials
{
  using namespace dealii;

  namespace
  {
    /// A velocity gradient times the step, row by row.
    template <int dim>
    using Gradient = std::array<double, dim * dim>;

    /// Up to this size of det - 1 the short series of the logarithm is exact.
    constexpr double limit_of_series = 0.02;



    /// det(I + A) - 1, without the cancellation of computing it so.
    template <int dim>
    inline double
    determinant_minus_one(const Gradient<dim> &A)
    {
      if constexpr (dim == 2)
        return A[0] + A[3] + (A[0] * A[3] - A[1] * A[2]);
      else
        {
          const double minor_x = A[4] * A[8] - A[5] * A[7];
          const double minor_y = A[0] * A[8] - A[2] * A[6];
          const double minor_z = A[0] * A[4] - A[1] * A[3];
          return (A[0] + A[4] + A[8]) + (minor_x + minor_y + minor_z) +
                 (A[0] * minor_x - A[1] * (A[3] * A[8] - A[5] * A[6]) +
                  A[2] * (A[3] * A[7] - A[4] * A[6]));
        }
    }



    /// ln(1 + x) = 2 artanh(x / (2 + x)), to round-off for |x| below
    /// limit_of_series; free of calls, unlike std::log1p.
    inline double
    log_of_one_plus(const double x)
    {
      const double y = x / (2. + x), y2 = y * y;
      return 2. * y * (1. + y2 * (1. / 3. + y2 * (1. / 5. + y2 * (1. / 7.))));
    }



    /// Deviator of sym(A) in the order of n_stress.
    template <int dim>
    inline Stress<dim>
    strain_deviator(const Gradient<dim> &A)
    {
      Stress<dim> strain{};
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        {
          const unsigned int i = stress_index[c][0], j = stress_index[c][1];
          if (i < dim && j < dim)
            strain[c] = .5 * (A[i * dim + j] + A[j * dim + i]);
        }
      return deviator(strain);
    }



    /**
     * The vector of tan(angle/2) of the rotation by Cayley's form of the spin
     * of half a step: (dt/4) curl(v)/2 = (dt/8) (L_ij - L_ji). In two
     * dimensions it points along z.
     */
    template <int dim>
    inline std::array<double, 3>
    half_angle(const Gradient<dim> &A)
    {
      std::array<double, 3> result{};
      for (unsigned int i = 0; i < dim; ++i)
        {
          const unsigned int j = (i + 2) % 3; // (1,0), (2,1), (0,2)
          if (j < dim)
            result[3 - i - j] = .125 * (A[i * dim + j] - A[j * dim + i]);
        }
      return result;
    }



    /**
     * The rotation of a quaternion (a, b) that need not have unit length.
     *
     * @param scale 1 / (a^2 + b^2).
     */
    template <int dim>
    inline Rotation<dim>
    rotation_matrix(const double                 a,
                    const std::array<double, 3> &b,
                    const double                 scale)
    {
      Rotation<dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          if (i == j)
            {
              const double u = b[(i + 1) % 3], v = b[(i + 2) % 3];
              result[i * dim + j] = 1. - 2. * scale * (u * u + v * v);
            }
          else
            {
              const double sign = (i + 3 - j) % 3 == 1 ? 1. : -1.;
              result[i * dim + j] =
                2. * scale * (b[i] * b[j] + sign * a * b[3 - i - j]);
            }
      return result;
    }
  } // namespace



  template <int dim>
  void
  StrainIncrements<dim>::compute(
    const ArrayView<const Tensor<2, dim>> velocity_gradients,
    const double                          step)
  {
    Assert(velocity_gradients.size() <= capacity, ExcInternalError());
    const unsigned int n = velocity_gradients.size();
    time_step            = step;

    // From rows to columns, four runs at a time. There are some twenty runs,
    // and what is left behind whole vectors would take as long as these: so
    // the last run fills up the last vector.
    const unsigned int            n_padded = (n + vector - 1) / vector * vector;
    std::array<Column, dim * dim> gradient;
    for (unsigned int r = 0; r < n_padded; r += Lanes::n)
      {
        const double *rows[Lanes::n];
        for (unsigned int k = 0; k < Lanes::n; ++k)
          rows[k] = &velocity_gradients[std::min(r + k, n - 1)][0][0];
        for (unsigned int c = 0; c + Lanes::n <= gradient.size(); c += Lanes::n)
          {
            Lanes parts[Lanes::n];
            for (unsigned int k = 0; k < Lanes::n; ++k)
              parts[k] = load<Lanes>(rows[k] + c);
            transpose(parts);
            for (unsigned int k = 0; k < Lanes::n; ++k)
              store(step * parts[k], &gradient[c + k][r]);
          }
        for (unsigned int c = gradient.size() / Lanes::n * Lanes::n;
             c < gradient.size();
             ++c)
          store(step * Lanes(rows[0][c], rows[1][c], rows[2][c], rows[3][c]),
                &gradient[c][r]);
      }

    Column volume_change;
    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int r = 0; r < n_padded; ++r)
      {
        Gradient<dim> A;
        for (unsigned int c = 0; c < A.size(); ++c)
          A[c] = gradient[c][r];

        volume_change[r]    = determinant_minus_one<dim>(A);
        volume_ratio[r]     = 1. + volume_change[r];
        log_volume_ratio[r] = log_of_one_plus(volume_change[r]);

        // The quaternions of Q and, doubling the angle, of R = Q^2.
        const auto          h      = half_angle<dim>(A);
        const double        square = h[0] * h[0] + h[1] * h[1] + h[2] * h[2];
        const double        scale  = 1. / (1. + square);
        const Rotation<dim> Q      = rotation_matrix<dim>(1., h, scale);
        const Rotation<dim> R =
          rotation_matrix<dim>(1. - square,
                               {{2. * h[0], 2. * h[1], 2. * h[2]}},
                               scale * scale);
        const Stress<dim> strain =
          rotated_deviator<dim>(strain_deviator<dim>(A), Q);

        for (unsigned int c = 0; c < R.size(); ++c)
          rotation[c][r] = R[c];
        for (unsigned int c = 0; c < strain.size(); ++c)
          deviatoric_strain[c][r] = strain[c];
      }

    std::uint64_t n_large = 0; // as wide as double, to be vectorized
    for (unsigned int r = 0; r < n_padded; ++r)
      n_large += !(std::abs(volume_change[r]) < limit_of_series);
    if (n_large != 0)
      for (unsigned int r = 0; r < n; ++r)
        if (!(std::abs(volume_change[r]) < limit_of_series))
          log_volume_ratio[r] = std::log1p(volume_change[r]);
  }



  template <int dim>
  void
  StrainIncrements<dim>::spread(const StrainIncrements              &of_runs,
                                const ArrayView<const std::uint32_t> run_of)
  {
    const unsigned int n_points = run_of.size();
    Assert(n_points <= capacity, ExcInternalError());
    static_assert(Selection::n <= vector);
    time_step = of_runs.time_step;
    for (std::size_t i = 0; i < n_points; i += Selection::n)
      {
        const Selection selected(run_of.data() + i);
        const auto      copy = [&](const Column &from, Column &to) {
          selected.copy(from.data(), &to[i]);
        };
        for (unsigned int c = 0; c < rotation.size(); ++c)
          copy(of_runs.rotation[c], rotation[c]);
        for (unsigned int c = 0; c < deviatoric_strain.size(); ++c)
          copy(of_runs.deviatoric_strain[c], deviatoric_strain[c]);
        copy(of_runs.volume_ratio, volume_ratio);
        copy(of_runs.log_volume_ratio, log_volume_ratio);
      }
  }

  template struct StrainIncrements<2>;
  template struct StrainIncrements<3>;
} // namespace mpm_granular::Materials
