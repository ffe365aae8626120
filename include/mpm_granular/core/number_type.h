#ifndef mpm_granular_core_number_type_h
#define mpm_granular_core_number_type_h

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace mpm_granular::Core
{
  /// The types of numbers in files.
  enum class NumberType
  {
    character,
    natural8,
    natural32,
    natural64,
    real32,
    real64
  };

  /// Bytes of a number.
  constexpr std::size_t
  size_of(const NumberType type)
  {
    switch (type)
      {
        case NumberType::natural32:
        case NumberType::real32:
          return 4;
        case NumberType::natural64:
        case NumberType::real64:
          return 8;
        default:
          return 1;
      }
  }

  /// The NumberType of the C++ type Number.
  template <class Number>
  constexpr NumberType
  number_type()
  {
    static_assert(std::is_same_v<Number, double> ||
                    std::is_same_v<Number, float> ||
                    (std::is_unsigned_v<Number> && sizeof(Number) != 2) ||
                    std::is_same_v<Number, char>,
                  "numbers of this type are not kept in files");
    if constexpr (std::is_same_v<Number, double>)
      return NumberType::real64;
    else if constexpr (std::is_same_v<Number, float>)
      return NumberType::real32;
    else if constexpr (std::is_same_v<Number, char>)
      return NumberType::character;
    else
      return sizeof(Number) == 1 ? NumberType::natural8 :
             sizeof(Number) == 4 ? NumberType::natural32 :
                                   NumberType::natural64;
  }
} // namespace mpm_granular::Core

#endif
