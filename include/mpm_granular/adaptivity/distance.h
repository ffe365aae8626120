#ifndef mpm_granular_adaptivity_distance_h
#define mpm_granular_adaptivity_distance_h

#include <deal.II/base/point.h>

#include <mpm_granular/adaptivity/criterion.h>
#include <mpm_granular/core/expression.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mpm_granular::Adaptivity
{
  /// A level for the cells near a part of the mesh's boundary, or near a
  /// surface that is given as a function.
  template <int dim>
  class Distance : public Criterion<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// @throws InputError for unknown boundaries.
    void
    prepare(const State<dim> &state) override;

    unsigned int
    wanted_level(const State<dim>  &state,
                 const unsigned int cell) const override;

  private:
    /// A segment, a triangle.
    using Piece = std::array<dealii::Point<dim>, dim>;

    void
    find_pieces(const State<dim> &state);
    /// The distance to the boundaries, if it is less than what counts as near.
    std::vector<double>
    distances_to_pieces(const State<dim> &state) const;

    std::vector<std::string>                     boundaries;
    std::string                                  text;
    mutable std::optional<Core::Expression<dim>> expression;
    double                                       near  = 0.1; ///< [m]
    unsigned int                                 level = highest_level;
    std::vector<Piece>  pieces;   ///< of the boundaries, of all ranks
    std::vector<double> of_nodes; ///< distances [m]
  };
} // namespace mpm_granular::Adaptivity

#endif
