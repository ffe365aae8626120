#ifndef mpm_granular_parameters_pattern_text_h
#define mpm_granular_parameters_pattern_text_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace mpm_granular::Parameters
{
  /// The pattern of numbers greater than 0 and at most @p upper.
  dealii::Patterns::Double
  positive_number(
    const double upper = dealii::Patterns::Double::max_double_value);

  /// The pattern of lists of names for subsections: different ones, without
  /// characters that have a meaning.
  class ListOfNames : public dealii::Patterns::List
  {
  public:
    ListOfNames();

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;
  };

  /// The pattern of a number of at least 0, or "automatic": the program finds
  /// one. See value_of().
  class AutomaticNumber : public dealii::Patterns::PatternBase
  {
  public:
    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

    /// What an entry that is "automatic" has as its value.
    static const std::string automatic;

    /// The number of an entry, or what the program has found.
    static double
    value_of(const std::string &entry, const double found);
  };

  /**
   * What a pattern allows, in words, say "a number from 0 to 90".
   *
   * @param pattern what PatternBase::description() gives.
   */
  std::string
  allowed_values(const std::string &pattern);

  /**
   * What is probably wrong with @p value, which @p pattern refuses: a unit
   * after the number, a decimal comma, a misspelt name. One or more sentences
   * with a blank in front, or nothing.
   *
   * @param unit of the entry, may be empty.
   */
  std::string
  hint_for(const std::string &value,
           const std::string &pattern,
           const std::string &unit);

  /**
   * The unit that a documentation text states: what follows "Units: " up to the
   * end of the sentence. Empty if there is none, or if it is "-" or "none".
   */
  std::string
  unit_in(const std::string &documentation);
} // namespace mpm_granular::Parameters

#endif
