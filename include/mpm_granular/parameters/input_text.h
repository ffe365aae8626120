#ifndef mpm_granular_parameters_input_text_h
#define mpm_granular_parameters_input_text_h

#include <optional>
#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /// "set Entry = value" in a parameter file, or --set "Section/Entry=value".
  struct Assignment
  {
    std::string path; ///< Section/Sub/Entry
    std::string value;
    std::string origin; ///< "file:line", or the option, for messages
  };

  /// "subsection Name" in a parameter file.
  struct OpenedSection
  {
    std::string path; ///< Section/Sub
    std::string origin;
  };

  /// What is written in a parameter file, whether declared or not.
  struct InputText
  {
    std::vector<Assignment> assignments; ///< of the file; the last one counts
    std::vector<Assignment> overrides;   ///< stronger than assignments
    std::vector<OpenedSection> sections;
  };

  /// Where parameters are read from: a file, or a text that is at hand.
  struct InputSource
  {
    /// @param file name of the file; empty: no file.
    InputSource(const std::string &file)
      : name(file)
    {}

    InputSource(const char *file)
      : name(file)
    {}

    /// @param name of the text in messages.
    InputSource(const std::string &name, const std::string &text)
      : name(name)
      , text(text)
    {}

    std::string                name;
    std::optional<std::string> text; ///< in place of what the file has
  };

  /**
   * Reads a parameter file in deal.II's format: "set Entry = value",
   * "subsection Name", "end", "include file", comments from # to the end of the
   * line, a \ at the end of a line that goes on in the next one. A file to
   * include is relative to the folder of the file that includes it.
   *
   * @param source the file; without a name: none.
   * @param overrides "Section/Sub/Entry=value".
   * @throws InputError with file and line for what is not of this format: a
   *   missing "end", an entry given twice in a file.
   */
  InputText
  read_input_text(const InputSource              &source,
                  const std::vector<std::string> &overrides);
} // namespace mpm_granular::Parameters

#endif
