#include <deal.II/base/patterns.h>

#include <mpm_granular/parameters/dimension.h>
#include <mpm_granular/parameters/entry.h>
#include <mpm_granular/parameters/input_text.h>
#include <mpm_granular/parameters/refusal.h>

namespace mpm_granular::Parameters
{
  namespace
  {
    const std::string name = "Dimension";
  }



  void
  declare_dimension(dealii::ParameterHandler &prm, const unsigned int dim)
  {
    prm.declare_entry(name,
                      "3",
                      dealii::Patterns::Selection("2|3"),
                      "2: triangles, plane strain, everything per metre of "
                      "thickness; 3: tetrahedra.");
    prm.set(name, dim == 2 ? "2" : "3");
  }



  unsigned int
  read_dimension(const InputSource              &source,
                 const std::vector<std::string> &overrides)
  {
    const InputText text      = read_input_text(source, overrides);
    unsigned int    dimension = 3;
    for (const auto *assignments : {&text.assignments, &text.overrides})
      for (const auto &assignment : *assignments)
        if (assignment.path == name)
          {
            if (assignment.value != "2" && assignment.value != "3")
              {
                dealii::ParameterHandler prm;
                declare_dimension(prm, dimension);
                refuse_value(entries_of(prm).front(), assignment);
              }
            dimension = assignment.value == "2" ? 2 : 3;
          }
    return dimension;
  }
} // namespace mpm_granular::Parameters
