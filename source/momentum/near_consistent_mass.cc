#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/block_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <mpm_granular/momentum/near_consistent_mass.h>

#include <cmath>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  namespace
  {
    /// Conjugate gradients give up after this many iterations; the condition
    /// number of a mass matrix is small, some ten are usual.
    constexpr unsigned int max_iterations = 1000;

    /// One block a component, one entry a node of the mesh.
    using NodeVector = BlockVector<double>;

    /// A field of the active nodes as one of all nodes, zero elsewhere.
    template <int dim>
    NodeVector
    on_all_nodes(const NodalVectors<dim>      &field,
                 const Grid::NodalFields<dim> &fields,
                 const unsigned int            n_nodes)
    {
      NodeVector result(dim, n_nodes);
      for (unsigned int slot = 0; slot < field.size(); ++slot)
        for (unsigned int d = 0; d < dim; ++d)
          result.block(d)[fields.active_nodes[slot]] = field[slot][d];
      return result;
    }

    template <int dim>
    NodalVectors<dim>
    on_active_nodes(const NodeVector             &vector,
                    const Grid::NodalFields<dim> &fields)
    {
      NodalVectors<dim> result(fields.n_active_nodes());
      for (unsigned int slot = 0; slot < result.size(); ++slot)
        for (unsigned int d = 0; d < dim; ++d)
          result[slot][d] = vector.block(d)[fields.active_nodes[slot]];
      return result;
    }

    /// Removes the prescribed components.
    template <int dim>
    void
    project(NodeVector                           &vector,
            const Grid::NodalFields<dim>         &fields,
            const Grid::VelocityConstraints<dim> *constraints)
    {
      if (constraints == nullptr)
        return;
      for (const auto &constraint : constraints->nodes)
        {
          const unsigned int node = fields.active_nodes[constraint.slot];
          for (unsigned int k = 0; k < constraint.n_directions; ++k)
            {
              double along = 0.;
              for (unsigned int d = 0; d < dim; ++d)
                along += constraint.direction[k][d] * vector.block(d)[node];
              for (unsigned int d = 0; d < dim; ++d)
                vector.block(d)[node] -= along * constraint.direction[k][d];
            }
        }
    }

    /// The mass matrix, or its diagonal's inverse, on admissible variations.
    template <int dim>
    struct ProjectedMass
    {
      const TrilinosWrappers::SparseMatrix &matrix;
      const Grid::NodalFields<dim>         &fields;
      const Grid::VelocityConstraints<dim> *constraints;

      void
      vmult(NodeVector &result, const NodeVector &vector) const
      {
        for (unsigned int d = 0; d < dim; ++d)
          matrix.vmult(result.block(d), vector.block(d));
        project(result, fields, constraints);
      }
    };

    template <int dim>
    struct ProjectedJacobi
    {
      const TrilinosWrappers::SparseMatrix &matrix;
      const Grid::NodalFields<dim>         &fields;
      const Grid::VelocityConstraints<dim> *constraints;

      void
      vmult(NodeVector &result, const NodeVector &vector) const
      {
        result = vector;
        for (const unsigned int node : fields.active_nodes)
          {
            const double diagonal = matrix.diag_element(node);
            for (unsigned int d = 0; d < dim; ++d)
              result.block(d)[node] /= diagonal;
          }
        project(result, fields, constraints);
      }
    };
  } // namespace

  template <int dim>
  void
  NearConsistentMass<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Consistent part",
                      alpha,
                      "alpha of M_alpha = alpha M + (1 - alpha) M_l; 0 is the "
                      "lumped matrix, 1 the consistent one, which is singular "
                      "where cells hold few points. Units: -.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Solver tolerance",
                      tolerance,
                      "Residual of the conjugate gradients, relative to the "
                      "momentum. Units: -.",
                      Patterns::Double(1e-16, 1.));
  }

  template <int dim>
  void
  NearConsistentMass<dim>::check() const
  {
    require(
      alpha < 1.,
      "Scheme/Consistent part must be below 1 (the consistent mass matrix "
      "is singular where cells hold few points); given: " +
        std::to_string(alpha) + ".");
  }

  template <int dim>
  void
  NearConsistentMass<dim>::attach(const Mesh::BackgroundMesh<dim> &mesh)
  {
    DynamicSparsityPattern pattern(mesh.n_nodes());
    DoFTools::make_sparsity_pattern(mesh.dof_handler(), pattern);
    matrix.reinit(pattern);
  }

  template <int dim>
  void
  NearConsistentMass<dim>::assemble(const Grid::NodalFields<dim> &new_fields)
  {
    fields = &new_fields;
    matrix = 0.;
    for (unsigned int c = 0; c < fields->active_cells.size(); ++c)
      {
        std::vector<types::global_dof_index> nodes;
        for (const unsigned int slot : fields->cell_nodes[c])
          nodes.push_back(fields->active_nodes[slot]);
        FullMatrix<double> local(dim + 1, dim + 1);
        for (unsigned int i = 0; i <= dim; ++i)
          for (unsigned int j = 0; j <= dim; ++j)
            {
              const double mass = fields->cell_sums[c].mass[i * (dim + 1) + j];
              local(i, j) += alpha * mass;
              local(i, i) += (1. - alpha) * mass;
            }
        matrix.add(nodes, local);
      }
    matrix.compress(VectorOperation::add);
  }

  template <int dim>
  void
  NearConsistentMass<dim>::solve(
    const NodalVectors<dim>              &momentum,
    const Grid::VelocityConstraints<dim> *constraints,
    NodalVectors<dim>                    &velocity)
  {
    NodalVectors<dim> prescribed(momentum.size());
    if (constraints != nullptr)
      constraints->apply(prescribed);
    NodeVector solution = on_all_nodes(prescribed, *fields, matrix.m());
    NodeVector residual = on_all_nodes(momentum, *fields, matrix.m());
    NodeVector image(residual);
    for (unsigned int d = 0; d < dim; ++d)
      matrix.vmult(image.block(d), solution.block(d));
    residual -= image;
    project(residual, *fields, constraints);

    const double         scale = residual.l2_norm();
    SolverControl        control(max_iterations, tolerance * scale);
    SolverCG<NodeVector> cg(control);
    NodeVector           variation(residual);
    variation = 0.;
    try
      {
        if (scale > 0.)
          cg.solve(ProjectedMass<dim>{matrix, *fields, constraints},
                   variation,
                   residual,
                   ProjectedJacobi<dim>{matrix, *fields, constraints});
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw ComputationError(
          "The conjugate gradients for the mass matrix do not converge. Try a "
          "smaller Scheme/Consistent part or a larger Solver tolerance.");
      }
    solution += variation;
    velocity = on_active_nodes(solution, *fields);
  }

  template <int dim>
  void
  NearConsistentMass<dim>::multiply(const NodalVectors<dim> &velocity,
                                    NodalVectors<dim>       &momentum) const
  {
    const NodeVector vector = on_all_nodes(velocity, *fields, matrix.m());
    NodeVector       image(vector);
    for (unsigned int d = 0; d < dim; ++d)
      matrix.vmult(image.block(d), vector.block(d));
    momentum = on_active_nodes(image, *fields);
  }

  template <int dim>
  double
  NearConsistentMass<dim>::time_step_factor() const
  {
    // The worst case, a cell with too few points for a regular mass matrix;
    // full cells would allow sqrt(1 - alpha (dim+1)/(dim+2)).
    return std::sqrt(1. - alpha);
  }

  template class NearConsistentMass<2>;
  template class NearConsistentMass<3>;

  namespace
  {
    const std::string documentation =
      "alpha M + (1 - alpha) M_l, a Trilinos matrix solved with conjugate "
      "gradients (the paper's M_alpha).";
    const MassMatrixRegistry<2>::Entry<NearConsistentMass<2>>
      plane("near-consistent", documentation);
    const MassMatrixRegistry<3>::Entry<NearConsistentMass<3>>
      space("near-consistent", documentation);
  } // namespace
} // namespace mpm_granular::Momentum
