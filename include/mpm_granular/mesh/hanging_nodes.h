#ifndef mpm_granular_mesh_hanging_nodes_h
#define mpm_granular_mesh_hanging_nodes_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

namespace mpm_granular::Mesh
{
  /**
   * What keeps the linear space continuous where cells of different levels meet
   * (T60): the value at a *hanging* node, a vertex on an edge or face of a
   * larger cell, is a mean of those at the corners of that edge or face.
   *
   * @param dofs of the linear space; the constraints are in its global numbers.
   * @return the constraints, of which those of the nodes of own cells are
   *   complete; no constraint depends on another.
   */
  template <int dim>
  dealii::AffineConstraints<double>
  hanging_nodes(const dealii::DoFHandler<dim> &dofs);
} // namespace mpm_granular::Mesh

#endif
