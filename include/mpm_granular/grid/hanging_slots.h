#ifndef mpm_granular_grid_hanging_slots_h
#define mpm_granular_grid_hanging_slots_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace mpm_granular::Grid
{
  /// Adds @p factor times @p value to @p sum.
  inline void
  add_scaled(double &sum, const double factor, const double value)
  {
    sum += factor * value;
  }

  template <int dim>
  void
  add_scaled(dealii::Tensor<1, dim>       &sum,
             const double                  factor,
             const dealii::Tensor<1, dim> &value)
  {
    sum += factor * value;
  }

  template <std::size_t n>
  void
  add_scaled(std::array<double, n>       &sum,
             const double                 factor,
             const std::array<double, n> &value)
  {
    for (std::size_t i = 0; i < n; ++i)
      sum[i] += factor * value[i];
  }

  /**
   * Active cells can have vertices at hanging nodes. These have slots behind
   * those of the active (free) nodes, and no values of their own: a field there
   * is a mean of free nodes (T60), and what a vertex there receives goes to
   * these (T61).
   */
  class HangingSlots
  {
  public:
    /// The free nodes, by slot, and their parts in the mean.
    using Mean = std::vector<std::pair<unsigned int, double>>;

    void
    reinit(const std::size_t n_active_nodes)
    {
      n_free = n_active_nodes;
      means.clear();
    }

    /// @return the slot.
    unsigned int
    add(Mean mean)
    {
      means.push_back(std::move(mean));
      return n_free + means.size() - 1;
    }

    unsigned int
    size() const
    {
      return means.size();
    }

    /// The value at a slot of a field of the active nodes.
    template <class Value>
    Value
    value_at(const std::vector<Value> &field, const unsigned int slot) const
    {
      if (slot < n_free)
        return field[slot];
      Value sum = Value();
      for (const auto &[free, weight] : means[slot - n_free])
        add_scaled(sum, weight, field[free]);
      return sum;
    }

    /// Adds what a slot receives to a field of the active nodes.
    template <class Value>
    void
    add_at(std::vector<Value> &field,
           const unsigned int  slot,
           const Value        &value) const
    {
      if (slot < n_free)
        add_scaled(field[slot], 1., value);
      else
        for (const auto &[free, weight] : means[slot - n_free])
          add_scaled(field[free], weight, value);
    }

    /// Extends a field of the active nodes to the hanging ones.
    template <class Value>
    void
    extend(std::vector<Value> &field) const
    {
      field.resize(n_free + means.size());
      for (unsigned int i = 0; i < means.size(); ++i)
        {
          field[n_free + i] = Value();
          for (const auto &[free, weight] : means[i])
            add_scaled(field[n_free + i], weight, field[free]);
        }
    }

  private:
    std::size_t       n_free = 0;
    std::vector<Mean> means; ///< by slot
  };
} // namespace mpm_granular::Grid

#endif
