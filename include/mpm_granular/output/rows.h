#ifndef mpm_granular_output_rows_h
#define mpm_granular_output_rows_h

#include <mpm_granular/output/contents.h>

#include <cstddef>
#include <vector>

namespace mpm_granular::Output
{
  // How Contents become arrays of numbers, in all formats alike.

  /// The width of positions and vectors, also in 2D: what programs that draw
  /// expect.
  constexpr unsigned int n_directions = 3;

  /// How many numbers of a field a node has in the file.
  inline unsigned int
  width_of(const Field &field)
  {
    return field.n_components == 1 ? 1 : n_directions;
  }

  /// The number of a field in a column, zero in those it does not have.
  inline double
  number_of(const Field       &field,
            const std::size_t  node,
            const unsigned int column)
  {
    return column < field.n_components ? field.value(node, column) : 0.;
  }

  /// The coordinate of a node along x, y or z [m].
  template <int item_dim, int dim>
  double
  coordinate_of(const Contents<item_dim, dim> &contents,
                const std::size_t              node,
                const unsigned int             column)
  {
    return column < dim ? contents.position(node)[column] : 0.;
  }

  /// The vertex of an item, in deal.II's order, that VTK and XDMF have as
  /// number @p k: theirs goes around the sides of hypercubes.
  inline unsigned int
  place_of(const dealii::ReferenceCell shape, const unsigned int k)
  {
    return shape.is_hyper_cube() && k % 4 >= 2 ? k ^ 1u : k;
  }

  /// Makes @p rows the rows of an array of numbers value(row, column) from row
  /// @p first on.
  template <class Number, class Value>
  void
  fill_rows(std::vector<Number> &rows,
            const std::size_t    first,
            const std::size_t    n_rows,
            const unsigned int   width,
            const Value         &value)
  {
    rows.resize(n_rows * width);
    for (std::size_t row = 0; row < n_rows; ++row)
      for (unsigned int c = 0; c < width; ++c)
        rows[row * width + c] = static_cast<Number>(value(first + row, c));
  }
} // namespace mpm_granular::Output

#endif
