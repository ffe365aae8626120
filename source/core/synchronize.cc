#include <fcntl.h>
#include <unistd.h>

#include <mpm_granular/core/synchronize.h>

#include <filesystem>

namespace mpm_granular::Core
{
  namespace fs = std::filesystem;

  void
  synchronize(const std::string &path)
  {
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    if (descriptor >= 0)
      {
        ::fsync(descriptor);
        ::close(descriptor);
      }
  }



  void
  replace_file(const std::string &temporary, const std::string &path)
  {
    synchronize(temporary);
    fs::rename(temporary, path);
    const fs::path folder = fs::path(path).parent_path();
    synchronize(folder.empty() ? "." : folder.string());
  }
} // namespace mpm_granular::Core
