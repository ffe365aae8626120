#ifndef mpm_granular_parameters_file_name_h
#define mpm_granular_parameters_file_name_h

#include <string>

namespace mpm_granular::Parameters
{
  /**
   * Finds a file that an entry of a parameter file names. A relative name is
   * looked for in the folder the parameter file was named in, and, if the
   * parameter file is a symbolic link, in the folder it points to.
   *
   * @param name the value of the entry.
   * @param parameter_file the parameter file as named on the command line;
   *   empty: the current folder counts.
   * @param entry full name of the entry, for the message.
   * @return a path that can be opened from the current folder.
   * @throws InputError if there is no such file, or it is a folder or cannot be
   *   read.
   */
  std::string
  resolve_input_file(const std::string &name,
                     const std::string &parameter_file,
                     const std::string &entry);
} // namespace mpm_granular::Parameters

#endif
