#ifndef mpm_granular_momentum_near_consistent_mass_h
#define mpm_granular_momentum_near_consistent_mass_h

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <mpm_granular/momentum/mass_matrix.h>

namespace mpm_granular::Momentum
{
  /**
   * M_alpha = alpha M + (1 - alpha) M_l (T11), a Trilinos matrix on all nodes
   * with the contributions of this rank's points; the sum over the ranks is
   * taken in its products. Rows of nodes that are not active are zero, and so
   * are vectors there. Positive definite on the active nodes for alpha < 1,
   * whatever the points.
   *
   * Prescribed velocities are kept exactly by conjugate gradients in the space
   * of admissible variations.
   */
  template <int dim>
  class NearConsistentMass : public MassMatrix<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh) override;

    void
    assemble(Grid::NodalFields<dim> &fields) override;

    void
    solve(const NodalVectors<dim>              &momentum,
          const Grid::VelocityConstraints<dim> *constraints,
          NodalVectors<dim>                    &velocity) override;

    void
    multiply(const NodalVectors<dim> &velocity,
             NodalVectors<dim>       &momentum) const override;

    double
    time_step_factor() const override;

  private:
    double                                 alpha     = 0.5;
    double                                 tolerance = 1e-12;
    dealii::TrilinosWrappers::SparseMatrix matrix;
    const Mesh::BackgroundMesh<dim>       *mesh = nullptr;
    std::vector<double>                    diagonal; ///< by slot, of all ranks
    Grid::NodalFields<dim>                *fields = nullptr;
  };
} // namespace mpm_granular::Momentum

#endif
