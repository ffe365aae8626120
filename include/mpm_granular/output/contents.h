#ifndef mpm_granular_output_contents_h
#define mpm_granular_output_contents_h

#include <deal.II/base/point.h>
#include <deal.II/grid/reference_cell.h>

#include <boost/container/static_vector.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// A quantity to be written, as a function of the index of a node.
  struct Field
  {
    std::string  name;
    std::string  unit;
    unsigned int n_components; ///< 1, or dim for a vector

    /// The value of a component at a node.
    std::function<double(const std::size_t node, const unsigned int component)>
      value;

    bool is_natural = false; ///< a natural number, below 2^32
  };

  /// The nodes of an item, in deal.II's order.
  template <int item_dim>
  using ItemNodes =
    boost::container::static_vector<std::size_t, (1u << item_dim)>;

  /**
   * What a file shows of this rank: items of one shape, of dimension @p item_dim
   * (0 for points), with nodal fields. Nothing is copied; arrays are made one
   * after the other.
   */
  template <int item_dim, int dim>
  struct Contents
  {
    dealii::ReferenceCell shape; ///< of the items
    std::size_t           n_items;
    std::size_t           n_nodes;

    /// The nodes of an item.
    std::function<ItemNodes<item_dim>(const std::size_t)> nodes;

    /// The position of a node [m].
    std::function<dealii::Point<dim>(const std::size_t)> position;

    std::vector<Field> fields;
  };
} // namespace mpm_granular::Output

#endif
