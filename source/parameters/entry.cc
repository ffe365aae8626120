#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <mpm_granular/parameters/entry.h>

#include <algorithm>
#include <sstream>

namespace mpm_granular::Parameters
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    /// Undoes what deal.II does to names in XML: "_20" is a space.
    std::string
    demangle(const std::string &mangled)
    {
      std::string name;
      for (std::size_t i = 0; i < mangled.size(); ++i)
        if (mangled[i] == '_' && i + 2 < mangled.size())
          {
            name += static_cast<char>(
              std::stoi(mangled.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          name += mangled[i];
      return name;
    }

    void
    collect(const Tree                     &tree,
            const std::vector<std::string> &section,
            std::vector<Entry>             &entries)
    {
      for (const auto &[mangled, node] : tree)
        if (node.get_optional<std::string>("pattern_description"))
          entries.push_back({section,
                             demangle(mangled),
                             node.get<std::string>("value"),
                             node.get<std::string>("default_value"),
                             node.get<std::string>("documentation"),
                             node.get<std::string>("pattern_description")});

      for (const auto &[mangled, node] : tree)
        if (!node.get_optional<std::string>("pattern_description") &&
            !node.get_optional<std::string>("alias"))
          {
            auto inner = section;
            inner.push_back(demangle(mangled));
            collect(node, inner, entries);
          }
    }
  } // namespace



  std::string
  joined(const std::vector<std::string> &section)
  {
    std::string path;
    for (const auto &name : section)
      path += (path.empty() ? "" : "/") + name;
    return path;
  }



  std::string
  Entry::path() const
  {
    return section.empty() ? name : joined(section) + "/" + name;
  }



  std::vector<Entry>
  entries_of(const dealii::ParameterHandler &prm)
  {
    // XML is the only form that is complete whatever characters names have.
    using dealii::ParameterHandler;
    std::stringstream xml;
    prm.print_parameters(xml,
                         ParameterHandler::XML |
                           ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_xml(xml, tree);

    std::vector<Entry> entries;
    collect(tree.get_child("ParameterHandler"), {}, entries);
    return entries;
  }



  std::vector<std::string>
  required_but_not_set(const dealii::ParameterHandler &prm)
  {
    std::vector<std::string> paths;
    for (std::string path : prm.get_entries_wrongly_not_set())
      {
        std::replace(path.begin(), path.end(), '.', '/');
        paths.push_back(demangle(path));
      }
    return paths;
  }



  const Entry *
  find_entry(const std::vector<Entry> &entries, const std::string &path)
  {
    const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry &entry) {
        return entry.path() == path;
      });
    return found == entries.end() ? nullptr : &*found;
  }



  void
  set_value(dealii::ParameterHandler &prm,
            const Entry              &entry,
            const std::string        &value)
  {
    struct Inside
    {
      Inside(dealii::ParameterHandler       &prm,
             const std::vector<std::string> &section)
        : prm(prm)
        , depth(section.size())
      {
        for (const auto &name : section)
          prm.enter_subsection(name);
      }
      ~Inside()
      {
        for (std::size_t i = 0; i < depth; ++i)
          prm.leave_subsection();
      }
      dealii::ParameterHandler &prm;
      const std::size_t         depth;
    } const inside(prm, entry.section);

    prm.set(entry.name, value);
  }
} // namespace mpm_granular::Parameters
