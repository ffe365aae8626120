#include <mpm_granular/adaptivity/region.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  void
  Region<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Level",
                      text,
                      "The level, an expression of x, y, z and t, say "
                      "'if(x<1, 2, 0)'; rounded to a whole number. A cell gets "
                      "the highest value at its vertices; what lies between "
                      "them is not seen. Units: none.");
  }

  template <int dim>
  void
  Region<dim>::check() const
  {
    expression.emplace(text, 1, "Level");
  }

  template <int dim>
  void
  Region<dim>::prepare(const State<dim> &state)
  {
    of_nodes.resize(state.mesh.n_nodes());
    for (unsigned int node = 0; node < of_nodes.size(); ++node)
      {
        const Point<dim> &place = state.mesh.node_position(node);
        const double      level = expression->value(place, state.time);
        if (!std::isfinite(level))
          throw ComputationError("'Level' of a region of the adaptive mesh, '" +
                                 text + "', must be a number everywhere; at " +
                                 Mesh::as_text(place) + " it is not.");
        of_nodes[node] = std::lround(
          std::min(std::max(level, 0.), static_cast<double>(highest_level)));
      }
  }

  template <int dim>
  unsigned int
  Region<dim>::wanted_level(const State<dim>  &state,
                            const unsigned int cell) const
  {
    unsigned int level = 0;
    for (const unsigned int node : state.mesh.nodes(cell))
      level = std::max(level, of_nodes[node]);
    return level;
  }

  template class Region<2>;
  template class Region<3>;

  namespace
  {
    const std::string documentation =
      "a level given as a function of place and time.";
    const CriterionRegistry<2>::Entry<Region<2>> region_2d("region",
                                                           documentation);
    const CriterionRegistry<3>::Entry<Region<3>> region_3d("region",
                                                           documentation);
  } // namespace
} // namespace mpm_granular::Adaptivity
