#ifndef mpm_granular_core_synchronize_h
#define mpm_granular_core_synchronize_h

#include <string>

namespace mpm_granular::Core
{
  /// Asks the system to bring the file or folder @p path to the disk, so that
  /// it survives a loss of power. What cannot be opened is passed over.
  void
  synchronize(const std::string &path);

  /// Gives the complete file @p temporary the name @p path in the same folder:
  /// at any moment either the old or the new file has that name, and the new
  /// one is on the disk.
  /// @throws std::filesystem::filesystem_error if that is not possible.
  void
  replace_file(const std::string &temporary, const std::string &path);
} // namespace mpm_granular::Core

#endif
