#include <mpm_granular/parameters/name_distance.h>

#include <algorithm>
#include <cctype>

namespace mpm_granular::Parameters
{
  namespace
  {
    std::string
    lower_case(std::string text)
    {
      for (char &letter : text)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return text;
    }

    /// Edit distance with exchanges of neighbours, by the usual table.
    std::size_t
    distance(const std::string &first, const std::string &second)
    {
      const std::size_t rows = first.size(), columns = second.size();
      std::vector<std::vector<std::size_t>> table(
        rows + 1, std::vector<std::size_t>(columns + 1));
      for (std::size_t i = 0; i <= rows; ++i)
        for (std::size_t j = 0; j <= columns; ++j)
          {
            if (i == 0 || j == 0)
              {
                table[i][j] = i + j;
                continue;
              }
            const bool differ = first[i - 1] != second[j - 1];
            table[i][j]       = std::min({table[i - 1][j] + 1,
                                          table[i][j - 1] + 1,
                                          table[i - 1][j - 1] + differ});
            if (i > 1 && j > 1 && first[i - 1] == second[j - 2] &&
                first[i - 2] == second[j - 1])
              table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
          }
      return table[rows][columns];
    }
  } // namespace



  std::string
  nearest_name(const std::string &typed, const std::vector<std::string> &names)
  {
    const std::string wanted = lower_case(typed);
    std::string       nearest;
    std::size_t       least = wanted.size() / 3 + 2;
    for (const auto &name : names)
      {
        const std::string candidate = lower_case(name);
        // The beginning of a name counts as nearly right.
        const bool is_beginning =
          wanted.size() >= 3 && candidate.rfind(wanted, 0) == 0;
        const std::size_t needed =
          is_beginning ? 1 : distance(wanted, candidate);
        if (needed < least && needed < wanted.size())
          {
            least   = needed;
            nearest = name;
          }
      }
    return nearest;
  }



  std::string
  did_you_mean(const std::string &typed, const std::vector<std::string> &names)
  {
    const std::string nearest = nearest_name(typed, names);
    return nearest.empty() ? "" : " Did you mean '" + nearest + "'?";
  }



  std::string
  quoted_list(const std::vector<std::string> &names)
  {
    std::string list;
    for (const auto &name : names)
      list += (list.empty() ? "'" : ", '") + name + "'";
    return list;
  }
} // namespace mpm_granular::Parameters
