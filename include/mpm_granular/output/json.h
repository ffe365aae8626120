#ifndef mpm_granular_output_json_h
#define mpm_granular_output_json_h

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mpm_granular::Output
{
  /// @p text as a JSON string, with quotes; control characters escaped.
  std::string
  json_string(const std::string &text);

  /// @p value as a JSON number that reads back to the same double; null if it
  /// is not finite, for which JSON has no number.
  std::string
  json_number(const double value);

  /// @p texts as a JSON list of strings.
  std::string
  json_list(const std::vector<std::string> &texts);

  /// A JSON object with its members in the order they are added.
  class JsonObject
  {
  public:
    /// Adds a string, number, truth value, list of strings, or object.
    template <class Value>
    JsonObject &
    add(const std::string &key, const Value &value)
    {
      members.emplace_back(json_string(key), text_of(value));
      return *this;
    }

    /// The object as text, one member a line.
    std::string
    text(const unsigned int indentation = 0) const;

  private:
    template <class Value>
    static std::string
    text_of(const Value &value)
    {
      if constexpr (std::is_same_v<Value, JsonObject>)
        return value.text();
      else if constexpr (std::is_same_v<Value, bool>)
        return value ? "true" : "false";
      else if constexpr (std::is_integral_v<Value>)
        return std::to_string(value);
      else if constexpr (std::is_floating_point_v<Value>)
        return json_number(value);
      else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
        return json_list(value);
      else
        return json_string(value);
    }

    std::vector<std::pair<std::string, std::string>> members;
  };
} // namespace mpm_granular::Output

#endif
