#ifndef mpm_granular_benchmarks_counted_h
#define mpm_granular_benchmarks_counted_h

#include <cmath>
#include <cstdint>

namespace mpm_granular::Benchmarks
{
  /// A number that counts operations: additions, multiplications, divisions and
  /// roots as one each; comparisons and changes of sign are none.
  struct Counted
  {
    Counted(const double value = 0.)
      : value(value)
    {}

    double value;

    static inline std::uint64_t n_operations = 0;
  };

  inline Counted
  counted(const double value)
  {
    ++Counted::n_operations;
    return value;
  }

  inline Counted
  operator+(const Counted &a, const Counted &b)
  {
    return counted(a.value + b.value);
  }

  inline Counted
  operator-(const Counted &a, const Counted &b)
  {
    return counted(a.value - b.value);
  }

  inline Counted
  operator*(const Counted &a, const Counted &b)
  {
    return counted(a.value * b.value);
  }

  inline Counted
  operator/(const Counted &a, const Counted &b)
  {
    return counted(a.value / b.value);
  }

  inline Counted
  sqrt(const Counted &a)
  {
    return counted(std::sqrt(a.value));
  }

  inline bool
  operator<(const Counted &a, const Counted &b)
  {
    return a.value < b.value;
  }

  inline bool
  operator>(const Counted &a, const Counted &b)
  {
    return a.value > b.value;
  }

  inline bool
  operator>=(const Counted &a, const Counted &b)
  {
    return a.value >= b.value;
  }
} // namespace mpm_granular::Benchmarks

#endif
