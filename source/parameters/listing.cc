#include <deal.II/base/utilities.h>

#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/listing.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <sstream>

namespace mpm_granular::Parameters
{
  namespace
  {
    using Section = std::vector<std::string>;

    /// Writes @p text as a comment in lines of at most 80 characters.
    void
    write_comment(std::ostream      &out,
                  const std::string &text,
                  const std::string &margin)
    {
      std::istringstream words(text);
      std::string        line, word;
      while (words >> word)
        {
          if (!line.empty() &&
              margin.size() + 3 + line.size() + word.size() > 80)
            {
              out << margin << '#' << line << '\n';
              line.clear();
            }
          line += " " + word;
        }
      if (!line.empty())
        out << margin << '#' << line << '\n';
    }



    /// How many subsections two entries share.
    std::size_t
    n_common(const Section &first, const Section &second)
    {
      const auto last = std::min(first.size(), second.size());
      return std::mismatch(first.begin(), first.begin() + last, second.begin())
               .first -
             first.begin();
    }



    std::string
    margin_of(const std::size_t depth)
    {
      return std::string(2 * depth, ' ');
    }



    /// Closes and opens subsections on the way from one entry to the next.
    void
    write_change_of_section(std::ostream  &out,
                            const Section &from,
                            const Section &into)
    {
      const std::size_t common = n_common(from, into);
      for (std::size_t depth = from.size(); depth > common; --depth)
        out << margin_of(depth - 1) << "end\n";
      for (std::size_t depth = common; depth < into.size(); ++depth)
        out << '\n' << margin_of(depth) << "subsection " << into[depth] << '\n';
    }



    void
    write_parameter_file(const std::vector<Entry> &entries, std::ostream &out)
    {
      Section section;
      bool    is_first = true;
      for (const auto &entry : entries)
        {
          const bool enters = entry.section != section;
          write_change_of_section(out, section, entry.section);
          section = entry.section;
          if (!enters && !is_first)
            out << '\n';
          is_first = false;

          const std::string margin = margin_of(section.size());
          write_comment(out, entry.documentation, margin);
          write_comment(out,
                        "Allowed: " + allowed_values(entry.pattern) +
                          ". Default: " +
                          (entry.default_value.empty() ? "nothing" :
                                                         entry.default_value) +
                          ".",
                        margin);
          out << margin << "set " << entry.name << " =";
          if (!entry.value.empty())
            out << ' ' << entry.value;
          out << '\n';
        }
      write_change_of_section(out, section, {});
    }



    /// @p text in a table, where | and < would have a meaning.
    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char letter : text)
        if (letter == '<')
          result += "&lt;";
        else if (letter == '|' || letter == '*' || letter == '_')
          result += std::string("\\") + letter;
        else
          result += letter;
      return result;
    }



    /// @p text as code in a table.
    std::string
    code(const std::string &text)
    {
      if (text.empty())
        return "";
      std::string result;
      for (const char letter : text)
        result += letter == '|' ? "\\|" : std::string(1, letter);
      return "`" + result + "`";
    }



    /// The text without its statement of the unit, which has its own column.
    std::string
    without_unit(const std::string &documentation)
    {
      const std::string text  = documentation + " ";
      const auto        begin = text.find("Units: ");
      if (begin == std::string::npos)
        return documentation;
      const auto end = std::min(text.find(". ", begin), text.size() - 2) + 2;
      return dealii::Utilities::trim(text.substr(0, begin) + text.substr(end));
    }



    /// The title of a section: "Materials/<name>, Law = elastic".
    std::string
    title(const Section &section)
    {
      std::string text;
      for (const auto &name : section)
        text += (text.empty()                                     ? "" :
                 DocumentationHandler::is_section_of_choice(name) ? ", " :
                                                                    "/") +
                name;
      return text.empty() ? "Outside of all subsections" : text;
    }



    void
    write_heading(std::ostream &out, const Section &section)
    {
      const auto level =
        std::min<std::size_t>(std::max<std::size_t>(section.size() + 1, 2), 6);
      out << '\n'
          << std::string(level, '#') << ' ' << escaped(title(section))
          << "\n\n| Entry | Default | Unit | Allowed | Meaning |\n"
          << "|---|---|---|---|---|\n";
    }



    void
    write_markdown(const std::vector<Entry> &entries, std::ostream &out)
    {
      out << "# Parameters\n\n"
             "Every entry of the parameter file by its subsection, as printed "
             "by `mpm_granular --print-parameters=markdown`. \"Law = elastic\" "
             "in a title: these entries exist only with this choice. "
             "\"&lt;name>\": one subsection for each of the names that the "
             "entry \"Names\" lists.\n";
      const Entry *last = nullptr;
      for (const auto &entry : entries)
        {
          if (!last || last->section != entry.section)
            write_heading(out, entry.section);
          last = &entry;
          out << "| " << escaped(entry.name) << " | "
              << code(entry.default_value) << " | "
              << escaped(unit_in(entry.documentation)) << " | "
              << escaped(allowed_values(entry.pattern)) << " | "
              << escaped(without_unit(entry.documentation)) << " |\n";
        }
    }
  } // namespace



  void
  write(const std::vector<Entry> &entries, std::ostream &out, const Style style)
  {
    if (style == Style::parameter_file)
      write_parameter_file(entries, out);
    else
      write_markdown(entries, out);
  }
} // namespace mpm_granular::Parameters
