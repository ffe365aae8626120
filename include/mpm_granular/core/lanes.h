#ifndef mpm_granular_core_lanes_h
#define mpm_granular_core_lanes_h

#include <array>
#include <cstddef>
#include <type_traits>

namespace mpm_granular
{
  /**
   * Four numbers that are computed with at once, one in each lane: of four
   * points, or of the four nodes of a tetrahedron. Compilers make one SIMD
   * instruction of an operation, or two where registers are shorter. Runs of
   * points in a cell are short; eight lanes were slower.
   *
   * Functions of a template parameter Number are for one point with
   * Number = double and for four with Number = Lanes; load() and store() are
   * there for both.
   */
  struct Lanes
  {
    static constexpr unsigned int n = 4;

    typedef double Vector __attribute__((vector_size(n * sizeof(double))));

    /// Without alignment; an alias of double.
    typedef Vector InMemory __attribute__((aligned(sizeof(double))));

    Vector data;

    Lanes() = default;

    Lanes(const double value)
      : data{value, value, value, value}
    {}

    explicit Lanes(const Vector data)
      : data(data)
    {}

    Lanes(const double a, const double b, const double c, const double d)
      : data{a, b, c, d}
    {}

    Lanes &
    operator+=(const Lanes &other)
    {
      data += other.data;
      return *this;
    }

    Lanes &
    operator-=(const Lanes &other)
    {
      data -= other.data;
      return *this;
    }
  };

  inline Lanes
  operator+(const Lanes &a, const Lanes &b)
  {
    return Lanes(a.data + b.data);
  }

  inline Lanes
  operator-(const Lanes &a, const Lanes &b)
  {
    return Lanes(a.data - b.data);
  }

  inline Lanes
  operator*(const Lanes &a, const Lanes &b)
  {
    return Lanes(a.data * b.data);
  }

  /// The lesser of each two; the first, where one is not a number.
  inline Lanes
  minimum(const Lanes &a, const Lanes &b)
  {
    return Lanes(b.data < a.data ? b.data : a.data);
  }

  inline double
  minimum(const double a, const double b)
  {
    return b < a ? b : a;
  }

  /// The first lanes; the others are zero.
  inline Lanes
  first_of(const Lanes &a, const unsigned int n_first)
  {
    typedef long long Mask __attribute__((vector_size(4 * sizeof(long long))));
    const long long   n       = n_first;
    const Mask        is_kept = Mask{0, 1, 2, 3} < n;
    return Lanes(is_kept ? a.data : Lanes::Vector{});
  }

  inline double
  first_of(const double a, const unsigned int)
  {
    return a;
  }

  /// The sum of all lanes.
  inline double
  sum_of(const Lanes &a)
  {
    return (a.data[0] + a.data[1]) + (a.data[2] + a.data[3]);
  }

  /// Adds to a sum that is spread over lanes.
  inline void
  accumulate(Lanes &sum, const Lanes &value)
  {
    sum += value;
  }

  inline void
  accumulate(Lanes &sum, const double value)
  {
    sum += Lanes(value, 0., 0., 0.);
  }

  /// Adds @p factor times @p value to @p sum.
  template <std::size_t n>
  inline void
  add_scaled(std::array<Lanes, n>       &sum,
             const double                factor,
             const std::array<Lanes, n> &value)
  {
    for (std::size_t i = 0; i < n; ++i)
      sum[i] += factor * value[i];
  }

  /// Number = double or Lanes, as consecutive numbers in memory. Not by
  /// std::memcpy: what may write to anything makes compilers read pointers
  /// again and again.
  template <class Number>
  inline Number
  load(const double *from)
  {
    if constexpr (std::is_same_v<Number, Lanes>)
      return Lanes(*reinterpret_cast<const Lanes::InMemory *>(from));
    else
      return *from;
  }

  inline void
  store(const Lanes &lanes, double *to)
  {
    *reinterpret_cast<Lanes::InMemory *>(to) = lanes.data;
  }

  inline void
  store(const double number, double *to)
  {
    *to = number;
  }

  /// Lane j of a[i] becomes lane i of a[j].
  inline void
  transpose(Lanes (&a)[Lanes::n])
  {
    const auto low01 =
      __builtin_shufflevector(a[0].data, a[1].data, 0, 4, 2, 6);
    const auto high01 =
      __builtin_shufflevector(a[0].data, a[1].data, 1, 5, 3, 7);
    const auto low23 =
      __builtin_shufflevector(a[2].data, a[3].data, 0, 4, 2, 6);
    const auto high23 =
      __builtin_shufflevector(a[2].data, a[3].data, 1, 5, 3, 7);
    a[0].data = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
    a[1].data = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
    a[2].data = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    a[3].data = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
  }
} // namespace mpm_granular

#endif
