#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/expression.h>

#include <deal.II/base/utilities.h>

#include <map>

namespace mpm_granular::Core
{
  using namespace dealii;

  template <int dim>
  Expression<dim>::Expression(const std::string &text,
                              const unsigned int n_components,
                              const std::string &entry)
    : parser(std::make_shared<FunctionParser<dim>>(n_components))
  {
    const auto parts = Utilities::split_string_list(text, ';');
    require(parts.size() == n_components,
            "'" + entry + "' must be " + std::to_string(n_components) +
              " expression(s) separated by semicolons; given: '" + text + "'.");
    try
      {
        parser->initialize(dim == 2 ? "x,y,t" : "x,y,z,t",
                           parts,
                           {{"pi", numbers::PI}},
                           true);
        parser->set_time(0.);
        for (unsigned int c = 0; c < n_components; ++c)
          parser->value(Point<dim>(), c); // expressions are parsed at first use
      }
    catch (const std::exception &)
      {
        throw InputError("'" + entry + "' is not a valid expression of " +
                         (dim == 2 ? "x, y" : "x, y, z") + ", t and pi: '" +
                         text + "'.");
      }
  }

  template <int dim>
  double
  Expression<dim>::value(const Point<dim>  &place,
                         const double       time,
                         const unsigned int component) const
  {
    parser->set_time(time);
    return parser->value(place, component);
  }

  template class Expression<2>;
  template class Expression<3>;
} // namespace mpm_granular::Core
