#include <mpm_granular/mesh/mesh_source.h>

#include <algorithm>

namespace mpm_granular::Mesh
{
  unsigned int
  id_by_name(const std::map<std::string, unsigned int> &ids,
             const std::string                         &name,
             const std::string                         &kind)
  {
    const auto found = ids.find(name);
    if (found != ids.end())
      return found->second;
    if (!name.empty() && std::all_of(name.begin(), name.end(), ::isdigit))
      return std::stoul(name);

    std::string valid;
    for (const auto &[valid_name, id] : ids)
      valid += (valid.empty() ? "" : ", ") + valid_name;
    throw InputError("The mesh has no " + kind + " named '" + name +
                     "'; its names are: " + valid + ".");
  }
} // namespace mpm_granular::Mesh
