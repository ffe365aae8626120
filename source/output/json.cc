#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/output/json.h>

#include <cmath>
#include <cstdio>

namespace mpm_granular::Output
{
  std::string
  json_string(const std::string &text)
  {
    std::string quoted = "\"";
    for (const char character : text)
      switch (character)
        {
          case '"':
            quoted += "\\\"";
            break;
          case '\\':
            quoted += "\\\\";
            break;
          case '\n':
            quoted += "\\n";
            break;
          case '\t':
            quoted += "\\t";
            break;
          default:
            if (static_cast<unsigned char>(character) < 0x20)
              {
                char code[8];
                std::snprintf(code, sizeof(code), "\\u%04x", character);
                quoted += code;
              }
            else
              quoted += character;
        }
    return quoted + "\"";
  }



  std::string
  json_number(const double value)
  {
    return std::isfinite(value) ? Core::exact_text(value) : "null";
  }



  std::string
  json_list(const std::vector<std::string> &texts)
  {
    std::string list = "[";
    for (std::size_t i = 0; i < texts.size(); ++i)
      list += (i == 0 ? "" : ", ") + json_string(texts[i]);
    return list + "]";
  }



  std::string
  JsonObject::text(const unsigned int indentation) const
  {
    const std::string margin(indentation + 2, ' ');
    std::string       result = "{";
    for (std::size_t m = 0; m < members.size(); ++m)
      {
        result += (m == 0 ? "\n" : ",\n") + margin + members[m].first + ": ";
        // Objects inside were written without a margin of their own.
        for (const char character : members[m].second)
          {
            result += character;
            if (character == '\n')
              result += margin;
          }
      }
    return result + (members.empty() ? "}" : "\n" + margin.substr(2) + "}");
  }
} // namespace mpm_granular::Output
