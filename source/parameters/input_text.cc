#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/file_name.h>
#include <mpm_granular/parameters/input_text.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

namespace mpm_granular::Parameters
{
  using dealii::Utilities::trim;

  namespace
  {
    /// A path as it is compared: no blanks around the names.
    std::string
    trimmed_path(const std::string &path)
    {
      std::string trimmed;
      for (const auto &name : dealii::Utilities::split_string_list(path, '/'))
        trimmed += (trimmed.empty() ? "" : "/") + name;
      return trimmed;
    }



    /// Reads one file into an InputText.
    class Reader
    {
    public:
      Reader(const std::string &file, InputText &text, const unsigned int depth)
        : file(file)
        , text(text)
        , depth(depth)
      {}

      void
      read();

      void
      read(std::istream &stream);

    private:
      struct Section
      {
        std::string  path;
        std::string  name;
        unsigned int line;
        std::size_t  indentation;
      };

      std::string
      here() const
      {
        return file + ":" + std::to_string(line_number);
      }

      /// The next line without comment, joined with those it goes on in.
      bool
      next_line(std::istream &stream, std::string &line);

      void
      interpret(const std::string &line);

      void
      enter(const std::string &name);

      void
      leave();

      void
      assign(const std::string &name, const std::string &value);

      void
      include(const std::string &name);

      /// The error of a missing "end".
      [[noreturn]] void
      refuse_open_section() const;

      std::string
      path_of(const std::string &name) const
      {
        return sections.empty() ? name : sections.back().path + "/" + name;
      }

      const std::string                   file;
      InputText                          &text;
      const unsigned int                  depth;
      unsigned int                        line_number = 0; ///< of the last line
      std::size_t                         indentation = 0; ///< of the last line
      std::vector<Section>                sections;
      std::map<std::string, unsigned int> line_of_entry;
      std::string suspicion; ///< where the indentation betrays a missing end
    };



    void
    Reader::read()
    {
      std::error_code error;
      require(std::filesystem::exists(file, error),
              "There is no parameter file '" + file + "'.");
      require(!std::filesystem::is_directory(file, error),
              "'" + file + "' is a folder, not a parameter file.");
      std::ifstream stream(file);
      require(stream.good(),
              "The parameter file '" + file +
                "' cannot be opened; may it be read?");
      read(stream);
    }



    void
    Reader::read(std::istream &stream)
    {
      std::string line;
      while (next_line(stream, line))
        if (!line.empty())
          interpret(line);
      if (!sections.empty())
        refuse_open_section();
    }



    bool
    Reader::next_line(std::istream &stream, std::string &line)
    {
      line.clear();
      std::string part;
      bool        first = true;
      while (std::getline(stream, part))
        {
          if (++line_number == 1 && part.rfind("\xEF\xBB\xBF", 0) == 0)
            part.erase(0, 3); // byte order mark
          const bool is_comment = part.find('#') != std::string::npos;
          part.erase(std::min(part.find('#'), part.size()));
          if (first)
            indentation = part.find_first_not_of(" \t");
          part  = trim(part);
          first = false;

          const bool goes_on = !part.empty() && part.back() == '\\';
          if (goes_on)
            part.pop_back();
          line += part;
          // A line of comment within a long value does not end it.
          if (!goes_on && !(is_comment && part.empty() && !line.empty()))
            {
              line = trim(line);
              return true;
            }
        }
      line = trim(line);
      return !line.empty();
    }



    void
    Reader::interpret(const std::string &line)
    {
      const auto        blank   = line.find_first_of(" \t");
      const std::string keyword = line.substr(0, blank);
      const std::string rest =
        blank == std::string::npos ? "" : trim(line.substr(blank));
      const auto equal = rest.find('=');

      if ((keyword == "set" || keyword == "SET") && equal != std::string::npos)
        assign(trim(rest.substr(0, equal)), trim(rest.substr(equal + 1)));
      else if ((keyword == "subsection" || keyword == "SUBSECTION") &&
               !rest.empty())
        enter(rest);
      else if ((keyword == "end" || keyword == "END") && rest.empty())
        leave();
      else if ((keyword == "include" || keyword == "INCLUDE") && !rest.empty())
        include(rest);
      else
        throw InputError(
          here() + ": '" +
          (line.size() < 60 ? line : line.substr(0, 60) + "...") +
          "' is not understood. A line is 'set Entry = value', 'subsection "
          "Name', 'end', 'include file' or a comment after '#'.");
    }



    void
    Reader::enter(const std::string &name)
    {
      const std::string path = path_of(name);
      sections.push_back({path, name, line_number, indentation});
      text.sections.push_back({path, here()});
    }



    void
    Reader::leave()
    {
      require(!sections.empty(),
              here() + ": this 'end' has no 'subsection' that it ends.");
      const Section &section = sections.back();
      if (section.indentation != indentation && suspicion.empty())
        suspicion = " By the indentation, the 'end' of '" + section.path +
                    "' (line " + std::to_string(section.line) +
                    ") is missing before line " + std::to_string(line_number) +
                    ".";
      sections.pop_back();
    }



    void
    Reader::refuse_open_section() const
    {
      throw InputError(file + ":" + std::to_string(sections.back().line) +
                       ": the subsection '" + sections.back().path +
                       "' has no 'end'." + suspicion);
    }



    void
    Reader::assign(const std::string &name, const std::string &value)
    {
      const std::string path       = path_of(name);
      const auto [earlier, is_new] = line_of_entry.insert({path, line_number});
      require(is_new,
              here() + ": '" + path + "' has already been set in line " +
                std::to_string(earlier->second) + ".");
      text.assignments.push_back({path, value, here()});
    }



    void
    Reader::include(const std::string &name)
    {
      require(depth < 10,
              here() + ": files include each other without end, or more than "
                       "10 deep.");
      require(sections.empty(),
              here() + ": 'include' must stand outside of all subsections.");
      std::string path;
      try
        {
          path = resolve_input_file(name, file, "include");
        }
      catch (const InputError &error)
        {
          throw InputError(here() + ": " + error.what());
        }
      Reader(path, text, depth + 1).read();
    }



    Assignment
    parse_override(const std::string &argument)
    {
      const std::string origin = "--set \"" + argument + "\"";
      const auto        equal  = argument.find('=');
      require(equal != std::string::npos && equal > 0,
              origin + ": the form is --set \"Section/Entry=value\".");
      const std::string value = trim(argument.substr(equal + 1));
      // Such a value could not be written to a parameter file.
      require(value.find_first_of("#\n") == std::string::npos &&
                (value.empty() || value.back() != '\\'),
              origin + ": a value cannot contain '#' or line breaks, nor end "
                       "with '\\'.");
      return {trimmed_path(argument.substr(0, equal)), value, origin};
    }
  } // namespace



  InputText
  read_input_text(const InputSource              &source,
                  const std::vector<std::string> &overrides)
  {
    InputText text;
    Reader    reader(source.name, text, 0);
    if (source.text)
      {
        std::istringstream stream(*source.text);
        reader.read(stream);
      }
    else if (!source.name.empty())
      reader.read();
    for (const auto &argument : overrides)
      text.overrides.push_back(parse_override(argument));
    return text;
  }
} // namespace mpm_granular::Parameters
