#include <deal.II/dofs/dof_tools.h>

#include <mpm_granular/mesh/hanging_nodes.h>

#include <vector>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    /// deal.II knows hanging nodes of hypercubes; of simplices it does not (in
    /// 3D its function fails). An edge of a cell that is refined elsewhere has
    /// its midpoint hanging.
    template <int dim>
    void
    find_in_simplices(const DoFHandler<dim>     &dofs,
                      AffineConstraints<double> &constraints)
    {
      const auto &triangulation = dofs.get_triangulation();
      std::vector<types::global_dof_index> of_vertex(
        triangulation.n_vertices());
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          of_vertex[cell->vertex_index(v)] = cell->vertex_dof_index(v, 0);

      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int l : cell->line_indices())
          {
            const auto edge = cell->line(l);
            if (!edge->has_children())
              continue;
            const auto middle = of_vertex[edge->child(0)->vertex_index(1)];
            if (constraints.is_constrained(middle))
              continue;
            constraints.add_line(middle);
            for (const unsigned int end : {0, 1})
              constraints.add_entry(middle,
                                    of_vertex[edge->vertex_index(end)],
                                    0.5);
          }
    }
  } // namespace

  template <int dim>
  AffineConstraints<double>
  hanging_nodes(const DoFHandler<dim> &dofs)
  {
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    AffineConstraints<double> constraints(relevant);
    if (dofs.get_fe().reference_cell().is_simplex())
      find_in_simplices(dofs, constraints);
    else
      DoFTools::make_hanging_node_constraints(dofs, constraints);
    constraints.close();
    return constraints;
  }

  template AffineConstraints<double>
  hanging_nodes(const DoFHandler<2> &);
  template AffineConstraints<double>
  hanging_nodes(const DoFHandler<3> &);
} // namespace mpm_granular::Mesh
