#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/file_name.h>

#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace mpm_granular::Parameters
{
  namespace fs = std::filesystem;

  namespace
  {
    /// Where @p name may be, the first place first.
    std::vector<fs::path>
    places(const fs::path &name, const fs::path &parameter_file)
    {
      std::vector<fs::path> all = {parameter_file.parent_path() / name};
      std::error_code       error;
      if (name.is_relative() && fs::is_symlink(parameter_file, error))
        {
          const fs::path target = fs::canonical(parameter_file, error);
          if (!error)
            all.push_back(target.parent_path() / name);
        }
      return all;
    }
  } // namespace



  std::string
  resolve_input_file(const std::string &name,
                     const std::string &parameter_file,
                     const std::string &entry)
  {
    require(!name.empty(), "'" + entry + "' is empty: name a file.");

    std::string looked_for;
    for (const auto &place : places(name, parameter_file))
      {
        std::error_code error;
        if (!fs::exists(place, error))
          {
            looked_for +=
              (looked_for.empty() ? "'" : ", '") + place.string() + "'";
            continue;
          }
        require(!fs::is_directory(place, error),
                "'" + entry + "' names '" + place.string() +
                  "', which is a folder, not a file.");
        require(std::ifstream(place).good(),
                "'" + entry + "' names '" + place.string() +
                  "', which may not be read.");
        return place.string();
      }
    throw InputError("'" + entry + "' names the file '" + name +
                     "', which is not there; looked for: " + looked_for +
                     ". Relative names count from the folder of the parameter "
                     "file.");
  }
} // namespace mpm_granular::Parameters
