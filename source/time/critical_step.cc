#include <deal.II/base/symmetric_tensor.h>

#include <mpm_granular/time/critical_step.h>

#include <cmath>

namespace mpm_granular::Time
{
  using namespace dealii;

  template <int dim>
  double
  critical_step(const Mesh::SimplexCell<dim> &cell, const WaveMedium &medium)
  {
    // B^T D B acts on the velocities of the dim+1 nodes; its largest eigenvalue
    // is found with the power method. Eigenvalues of simplices are well apart
    // or equal, either way the Rayleigh quotient converges fast.
    constexpr unsigned int n_iterations = 60;

    std::array<Tensor<1, dim>, dim + 1> gradient, mode;
    for (unsigned int k = 0; k <= dim; ++k)
      {
        gradient[k] = cell.shape_gradient(k);
        // Close to the bulk mode, the stiffest one, and not orthogonal to
        // others.
        mode[k] = gradient[k];
        for (unsigned int d = 0; d < dim; ++d)
          mode[k][d] += .1 * gradient[k][(d + 1) % dim];
      }

    double eigenvalue = 0.;
    for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        double norm = 0.;
        for (const auto &v : mode)
          norm += v * v;
        Tensor<2, dim> velocity_gradient;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            mode[k] /= std::sqrt(norm);
            velocity_gradient += outer_product(mode[k], gradient[k]);
          }
        const SymmetricTensor<2, dim> rate = symmetrize(velocity_gradient);
        // Plane strain: the deviator is the one of space.
        const SymmetricTensor<2, dim> stress =
          (medium.bulk_modulus - 2. / 3. * medium.shear_modulus) * trace(rate) *
            unit_symmetric_tensor<dim>() +
          2. * medium.shear_modulus * rate;
        eigenvalue = 0.;
        for (unsigned int k = 0; k <= dim; ++k)
          {
            const Tensor<1, dim> image = stress * gradient[k];
            eigenvalue += image * mode[k];
            mode[k] = image;
          }
      }
    return 2. / std::sqrt((dim + 1) / medium.density * eigenvalue);
  }

  template double
  critical_step(const Mesh::SimplexCell<2> &, const WaveMedium &);
  template double
  critical_step(const Mesh::SimplexCell<3> &, const WaveMedium &);
} // namespace mpm_granular::Time
