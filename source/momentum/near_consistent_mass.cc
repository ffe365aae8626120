#include <deal.II/base/mpi.h>
#include <deal.II/lac/block_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/vector_memory.templates.h>

#include <mpm_granular/momentum/near_consistent_mass.h>

#include <cmath>
#include <tuple>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  namespace
  {
    /// Conjugate gradients give up after this many iterations; the condition
    /// number of a mass matrix is small, some ten are usual.
    constexpr unsigned int max_iterations = 1000;

    /**
     * A field of the active nodes, zero elsewhere: one block a component, one
     * entry a node of the mesh. Ranks that share a node have equal entries;
     * sums over the nodes count it once.
     */
    template <int dim>
    class NodeVector : public BlockVector<double>
    {
    public:
      NodeVector() = default;

      NodeVector(const NodalVectors<dim>      &field,
                 const Grid::NodalFields<dim> &fields,
                 const unsigned int            n_nodes)
        : BlockVector<double>(dim, n_nodes)
        , fields(&fields)
      {
        for (unsigned int slot = 0; slot < field.size(); ++slot)
          for (unsigned int d = 0; d < dim; ++d)
            block(d)[fields.active_nodes[slot]] = field[slot][d];
      }

      using BlockVector<double>::operator=;

      void
      reinit(const NodeVector &other, const bool omit_zeroing = false)
      {
        BlockVector<double>::reinit(other, omit_zeroing);
        fields = other.fields;
      }

      double
      operator*(const NodeVector &other) const
      {
        double sum = 0.;
        for (unsigned int slot = 0; slot < fields->n_active_nodes(); ++slot)
          if (fields->shared.counts(slot))
            for (unsigned int d = 0; d < dim; ++d)
              sum += block(d)[fields->active_nodes[slot]] *
                     other.block(d)[fields->active_nodes[slot]];
        return Utilities::MPI::sum(sum, fields->shared.communicator());
      }

      double
      l2_norm() const
      {
        return std::sqrt(*this * *this);
      }

      double
      add_and_dot(const double factor, const NodeVector &v, const NodeVector &w)
      {
        this->add(factor, v);
        return *this * w;
      }

      NodalVectors<dim>
      on_active_nodes() const
      {
        NodalVectors<dim> result(fields->n_active_nodes());
        for (unsigned int slot = 0; slot < result.size(); ++slot)
          for (unsigned int d = 0; d < dim; ++d)
            result[slot][d] = block(d)[fields->active_nodes[slot]];
        return result;
      }

    private:
      const Grid::NodalFields<dim> *fields = nullptr;
    };

    /// Removes the prescribed components.
    template <int dim>
    void
    project(NodeVector<dim>                      &vector,
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

    /// The product with the matrix, which is the sum of those of the ranks.
    template <int dim>
    void
    multiply(const TrilinosWrappers::SparseMatrix &matrix,
             Grid::NodalFields<dim>               &fields,
             const NodeVector<dim>                &vector,
             NodeVector<dim>                      &result)
    {
      for (unsigned int d = 0; d < dim; ++d)
        matrix.vmult(result.block(d), vector.block(d));
      if (fields.shared.is_serial())
        return;
      NodalVectors<dim> parts = result.on_active_nodes();
      fields.shared.sum(parts);
      result = NodeVector<dim>(parts, fields, matrix.m());
    }

    /// The mass matrix, or its diagonal's inverse, on admissible variations.
    template <int dim>
    struct ProjectedMass
    {
      const TrilinosWrappers::SparseMatrix &matrix;
      Grid::NodalFields<dim>               &fields;
      const Grid::VelocityConstraints<dim> *constraints;

      void
      vmult(NodeVector<dim> &result, const NodeVector<dim> &vector) const
      {
        multiply(matrix, fields, vector, result);
        project(result, fields, constraints);
      }
    };

    template <int dim>
    struct ProjectedJacobi
    {
      const std::vector<double>            &diagonal; ///< by slot
      const Grid::NodalFields<dim>         &fields;
      const Grid::VelocityConstraints<dim> *constraints;

      void
      vmult(NodeVector<dim> &result, const NodeVector<dim> &vector) const
      {
        result = vector;
        for (unsigned int slot = 0; slot < diagonal.size(); ++slot)
          for (unsigned int d = 0; d < dim; ++d)
            result.block(d)[fields.active_nodes[slot]] /= diagonal[slot];
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
  NearConsistentMass<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh)
  {
    mesh = &new_mesh;
    DynamicSparsityPattern pattern(mesh->n_nodes());
    for (unsigned int cell = 0; cell < mesh->n_cells(); ++cell)
      {
        const auto nodes = mesh->nodes(cell);
        mesh->hanging_nodes().add_entries_local_to_global(
          std::vector<types::global_dof_index>(nodes.begin(), nodes.end()),
          pattern);
      }
    matrix.reinit(pattern);
  }

  template <int dim>
  void
  NearConsistentMass<dim>::assemble(Grid::NodalFields<dim> &new_fields)
  {
    fields = &new_fields;
    matrix = 0.;
    fields->visit([&](const auto &cells) {
      constexpr unsigned int n_nodes =
        std::tuple_size_v<std::decay_t<decltype(cells.nodes[0])>>;
      FullMatrix<double>                   local(n_nodes, n_nodes);
      std::vector<types::global_dof_index> nodes(n_nodes);
      for (unsigned int c = 0; c < cells.nodes.size(); ++c)
        {
          const auto on_cell = mesh->nodes(fields->active_cells[c]);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              nodes[i]      = on_cell[i];
              double lumped = 0.;
              for (unsigned int j = 0; j < n_nodes; ++j)
                {
                  const double mass = cells.sums[c].mass(i, j);
                  local(i, j)       = alpha * mass;
                  lumped += (1. - alpha) * mass;
                }
              // Lumping keeps the sums of rows, also of those that go to
              // several nodes.
              if (const auto *mean =
                    mesh->hanging_nodes().get_constraint_entries(nodes[i]))
                for (const auto &[free, weight] : *mean)
                  matrix.add(free, free, weight * lumped);
              else
                local(i, i) += lumped;
            }
          mesh->hanging_nodes().distribute_local_to_global(local,
                                                           nodes,
                                                           matrix);
        }
    });
    matrix.compress(VectorOperation::add);

    diagonal.resize(fields->n_active_nodes());
    for (unsigned int slot = 0; slot < diagonal.size(); ++slot)
      diagonal[slot] = matrix.diag_element(fields->active_nodes[slot]);
    fields->shared.sum(diagonal.data(), 1);
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
    NodeVector<dim> solution(prescribed, *fields, matrix.m());
    NodeVector<dim> residual(momentum, *fields, matrix.m());
    NodeVector<dim> image(residual);
    Momentum::multiply(matrix, *fields, solution, image);
    residual -= image;
    project(residual, *fields, constraints);

    const double              scale = residual.l2_norm();
    SolverControl             control(max_iterations, tolerance * scale);
    SolverCG<NodeVector<dim>> cg(control);
    NodeVector<dim>           variation(residual);
    variation = 0.;
    try
      {
        if (scale > 0.)
          cg.solve(ProjectedMass<dim>{matrix, *fields, constraints},
                   variation,
                   residual,
                   ProjectedJacobi<dim>{diagonal, *fields, constraints});
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw ComputationError(
          "The conjugate gradients for the mass matrix do not converge. Try a "
          "smaller Scheme/Consistent part or a larger Solver tolerance.");
      }
    solution += variation;
    velocity = solution.on_active_nodes();
  }

  template <int dim>
  void
  NearConsistentMass<dim>::multiply(const NodalVectors<dim> &velocity,
                                    NodalVectors<dim>       &momentum) const
  {
    const NodeVector<dim> vector(velocity, *fields, matrix.m());
    NodeVector<dim>       image(vector);
    Momentum::multiply(matrix, *fields, vector, image);
    momentum = image.on_active_nodes();
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
