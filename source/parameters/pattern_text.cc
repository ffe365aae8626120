#include <deal.II/base/utilities.h>

#include <mpm_granular/parameters/name_distance.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <sstream>

namespace mpm_granular::Parameters
{
  namespace
  {
    const std::regex list_pattern(
      R"(\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\)(?: separated by <(.*)>)?\])");

    /// "from a to b" for the bounds of a pattern; the largest values that
    /// numbers can have are no bounds.
    std::string
    interval(const std::string &lower, const std::string &upper)
    {
      static const std::regex no_lower("-MAX_DOUBLE|-1\\.79769e\\+308|"
                                       "-2147483648"),
        no_upper("MAX_DOUBLE|1\\.79769e\\+308|2147483647"),
        smallest("[0-9.]+e-[23]\\d\\d");
      const bool positive  = std::regex_match(lower, smallest);
      const bool has_lower = !std::regex_match(lower, no_lower);
      const bool has_upper = !std::regex_match(upper, no_upper);
      if (positive)
        return " greater than 0" + (has_upper ? " and at most " + upper : "");
      if (has_lower && has_upper)
        return " from " + lower + " to " + upper;
      if (has_lower)
        return " of at least " + lower;
      if (has_upper)
        return " of at most " + upper;
      return "";
    }

    std::string
    allowed_numbers(const std::string &pattern, const std::string &what)
    {
      static const std::regex bounds(
        R"(\[\w+ (?:range )?(.+)\.\.\.(.+) \(inclusive\)\])");
      std::smatch match;
      return std::regex_match(pattern, match, bounds) ?
               what + interval(match[1], match[2]) :
               what;
    }

    std::string
    allowed_list(const std::smatch &match)
    {
      const std::string item = allowed_values(match[1]), least = match[2],
                        most      = match[3],
                        separator = match[4].matched ? match[4].str() : ",";
      const bool is_limited =
        most != std::to_string(std::numeric_limits<unsigned int>::max());
      std::string count = "a list";
      if (least == most)
        count = least + (least == "1" ? " value" : " values");
      else if (is_limited)
        count += " of " + least + " to " + most + " values";
      else if (least != "0")
        count +=
          " of at least " + least + (least == "1" ? " value" : " values");
      return count + " separated by '" + separator + "'" +
             (item == "any text" ? "" : ", each " + item);
    }

    std::vector<std::string>
    selection(const std::string &pattern)
    {
      static const std::regex names(R"(\[(?:Multiple)?Selection (.*) \])");
      std::smatch             match;
      if (!std::regex_match(pattern, match, names))
        return {};
      return dealii::Utilities::split_string_list(match[1], '|');
    }

    /// Whether one of the numbers in @p list is followed by something.
    bool
    has_letters_after_number(const std::string &list)
    {
      for (const auto &item : dealii::Utilities::split_string_list(list))
        {
          std::istringstream stream(item);
          double             number;
          std::string        rest;
          if (stream >> number && stream >> rest)
            return true;
        }
      return false;
    }

    bool
    starts_with(const std::string &text, const std::string &beginning)
    {
      return text.rfind(beginning, 0) == 0;
    }
  } // namespace



  ListOfNames::ListOfNames()
    : List(dealii::Patterns::Anything())
  {}



  bool
  ListOfNames::match(const std::string &text) const
  {
    const auto names = dealii::Utilities::split_string_list(text);
    for (auto name = names.begin(); name != names.end(); ++name)
      if (name->empty() || *name == "Names" ||
          name->find_first_of("/=#|") != std::string::npos ||
          std::find(names.begin(), name, *name) != name)
        return false;
    return List::match(text);
  }



  std::string
  ListOfNames::description(const OutputStyle) const
  {
    return "[Names]";
  }



  std::unique_ptr<dealii::Patterns::PatternBase>
  ListOfNames::clone() const
  {
    return std::make_unique<ListOfNames>();
  }



  const std::string AutomaticNumber::automatic = "automatic";



  bool
  AutomaticNumber::match(const std::string &text) const
  {
    return text == automatic || dealii::Patterns::Double(0.).match(text);
  }



  std::string
  AutomaticNumber::description(const OutputStyle) const
  {
    return "[Automatic or number]";
  }



  std::unique_ptr<dealii::Patterns::PatternBase>
  AutomaticNumber::clone() const
  {
    return std::make_unique<AutomaticNumber>();
  }



  double
  AutomaticNumber::value_of(const std::string &entry, const double found)
  {
    return entry == automatic ? found :
                                dealii::Utilities::string_to_double(entry);
  }



  dealii::Patterns::Double
  positive_number(const double upper)
  {
    return dealii::Patterns::Double(std::numeric_limits<double>::min(), upper);
  }



  std::string
  allowed_values(const std::string &pattern)
  {
    std::smatch match;
    if (std::regex_match(pattern, match, list_pattern))
      return allowed_list(match);
    if (starts_with(pattern, "[Double"))
      return allowed_numbers(pattern, "a number");
    // deal.II gives no bounds where they are those of unsigned numbers.
    if (pattern == "[Integer]")
      return "a whole number of at least 0";
    if (starts_with(pattern, "[Integer"))
      return allowed_numbers(pattern, "a whole number");
    if (starts_with(pattern, "[Selection"))
      return "one of " + quoted_list(selection(pattern));
    if (starts_with(pattern, "[MultipleSelection"))
      return "a list, separated by ',', of " + quoted_list(selection(pattern));
    if (pattern == "[Bool]")
      return "true or false";
    if (pattern == "[Anything]")
      return "any text";
    if (pattern == ListOfNames().description())
      return "different names separated by ',', without / = # | and not 'Names'";
    if (pattern == AutomaticNumber().description())
      return "'" + AutomaticNumber::automatic + "' or a number of at least 0";
    if (starts_with(pattern, "[FileName"))
      return "the name of a file";
    if (starts_with(pattern, "[DirectoryName"))
      return "the name of a folder";
    return pattern;
  }



  std::string
  hint_for(const std::string &value,
           const std::string &pattern,
           const std::string &unit)
  {
    static const std::regex decimal_comma(R"([-+]?\d+,\d+)"),
      with_point(R"([-+]?\d+\.\d*)");
    const bool is_integer       = pattern.find("[Integer") != std::string::npos;
    const bool may_be_automatic = pattern == AutomaticNumber().description();
    const bool is_number        = is_integer || may_be_automatic ||
                           pattern.find("[Double") != std::string::npos;
    const bool is_list = starts_with(pattern, "[List");

    if (is_number && has_letters_after_number(value))
      return " Give the number alone" +
             (unit.empty() ? "." : ", in " + unit + ".");
    if (is_number && !is_list && std::regex_match(value, decimal_comma))
      return " Decimals are separated by a point.";
    if (is_integer && !is_list && std::regex_match(value, with_point))
      return " It must be without decimals.";
    return did_you_mean(value,
                        may_be_automatic ?
                          std::vector<std::string>{AutomaticNumber::automatic} :
                          selection(pattern));
  }



  std::string
  unit_in(const std::string &documentation)
  {
    const std::string mark  = "Units: ";
    const auto        found = documentation.find(mark);
    if (found == std::string::npos)
      return "";
    const std::string rest = documentation.substr(found + mark.size()) + " ";
    const std::string unit =
      rest.substr(0, std::min(rest.find(". "), rest.size() - 1));
    return unit == "-" || unit == "none" ? "" : unit;
  }
} // namespace mpm_granular::Parameters
