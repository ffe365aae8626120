#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>

#include <mpm_granular/time/critical_step.h>

#include <array>
#include <cmath>
#include <vector>

namespace mpm_granular::Time
{
  using namespace dealii;

  namespace
  {
    /// Gradients of the shape functions at a place.
    template <class Cell>
    using Gradients = std::array<Tensor<1, Cell::dim>, Cell::n_nodes>;

    /// Places whose mean of B^T D B is that over the cell.
    template <int dim>
    std::vector<Gradients<Mesh::SimplexCell<dim>>>
    quadrature(const Mesh::SimplexCell<dim> &cell)
    {
      Gradients<Mesh::SimplexCell<dim>> gradients;
      for (unsigned int k = 0; k < gradients.size(); ++k)
        gradients[k] = cell.shape_gradient(k);
      return {gradients};
    }

    template <int dim>
    std::vector<Gradients<Mesh::BoxCell<dim>>>
    quadrature(const Mesh::BoxCell<dim> &cell)
    {
      std::vector<Gradients<Mesh::BoxCell<dim>>> result;
      const QGauss<dim>                          gauss(2);
      for (const Point<dim> &place : gauss.get_points())
        {
          std::array<double, dim> xi;
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = place[d];
          result.emplace_back();
          for (unsigned int k = 0; k < result.back().size(); ++k)
            result.back()[k] = cell.shape_gradient(xi, k);
        }
      return result;
    }
  } // namespace

  template <class Cell>
  double
  critical_step(const Cell &cell, const WaveMedium &medium)
  {
    // The operator acts on the velocities of the nodes; its largest eigenvalue
    // is found with the power method. Eigenvalues are well apart or equal,
    // either way the Rayleigh quotient converges fast.
    constexpr unsigned int n_iterations = 60;
    constexpr int          dim          = Cell::dim;
    const auto             gradients    = quadrature(cell);

    Gradients<Cell> mode;
    for (unsigned int k = 0; k < mode.size(); ++k)
      {
        // Close to the bulk mode, the stiffest one, and not orthogonal to
        // others.
        const Tensor<1, dim> bulk = cell.central_gradient(k);
        mode[k]                   = bulk;
        for (unsigned int d = 0; d < dim; ++d)
          mode[k][d] += .1 * bulk[(d + 1) % dim];
      }

    double eigenvalue = 0.;
    for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
      {
        double norm = 0.;
        for (const auto &v : mode)
          norm += v * v;
        for (auto &v : mode)
          v /= std::sqrt(norm);
        Gradients<Cell> image;
        for (const auto &gradient : gradients)
          {
            Tensor<2, dim> velocity_gradient;
            for (unsigned int k = 0; k < mode.size(); ++k)
              velocity_gradient += outer_product(mode[k], gradient[k]);
            const SymmetricTensor<2, dim> rate = symmetrize(velocity_gradient);
            // Plane strain: the deviator is the one of space.
            const SymmetricTensor<2, dim> stress =
              (medium.bulk_modulus - 2. / 3. * medium.shear_modulus) *
                trace(rate) * unit_symmetric_tensor<dim>() +
              2. * medium.shear_modulus * rate;
            for (unsigned int k = 0; k < mode.size(); ++k)
              image[k] += stress * gradient[k] / double(gradients.size());
          }
        eigenvalue = 0.;
        for (unsigned int k = 0; k < mode.size(); ++k)
          eigenvalue += image[k] * mode[k];
        mode = image;
      }
    return 2. / std::sqrt(Cell::n_nodes / medium.density * eigenvalue);
  }

  template double
  critical_step(const Mesh::SimplexCell<2> &, const WaveMedium &);
  template double
  critical_step(const Mesh::SimplexCell<3> &, const WaveMedium &);
  template double
  critical_step(const Mesh::BoxCell<2> &, const WaveMedium &);
  template double
  critical_step(const Mesh::BoxCell<3> &, const WaveMedium &);
} // namespace mpm_granular::Time
