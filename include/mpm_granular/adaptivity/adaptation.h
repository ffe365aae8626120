#ifndef mpm_granular_adaptivity_adaptation_h
#define mpm_granular_adaptivity_adaptation_h

#include <mpm_granular/adaptivity/adaptation_parameters.h>

#include <cstdint>
#include <vector>

namespace mpm_granular::Adaptivity
{
  /// When the mesh is to be adapted, and what level each cell is to have.
  template <int dim>
  class Adaptation
  {
  public:
    /// @param parameters must live as long.
    explicit Adaptation(const AdaptationParameters<dim> &parameters)
      : parameters(parameters)
    {}

    /// Whether there is any criterion.
    bool
    is_active() const
    {
      return parameters.is_wanted();
    }

    /**
     * Whether the mesh is to be adapted now.
     *
     * @param n_steps time steps since it was.
     * @param displacement how far any point, of any rank, has moved since then
     *   at most, over the size of the smallest cell.
     */
    bool
    is_due(const unsigned int n_steps, const double displacement) const;

    /// The levels that the cells of this rank, ghosts as well, are to have, by
    /// cell: the same on any number of ranks. A mesh that is given them cell by
    /// cell is to ask again until nothing changes. Collective.
    std::vector<std::uint8_t>
    wanted_levels(const State<dim> &state);

    /// Whether the last wanted_levels() would have been finer but for the
    /// maximum number of cells.
    bool
    is_limited() const
    {
      return limited;
    }

  private:
    /// What the criteria want, by cell.
    std::vector<unsigned int>
    ask_criteria(const State<dim> &state) const;
    /// Lowers the highest levels where the cells would be too many.
    void
    limit_number(const State<dim> &state, std::vector<unsigned int> &levels);

    const AdaptationParameters<dim> &parameters;
    bool                             limited = false;
  };
} // namespace mpm_granular::Adaptivity

#endif
