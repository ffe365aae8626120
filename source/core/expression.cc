#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/expression.h>

#include <iostream>
#include <map>
#include <sstream>

namespace mpm_granular::Core
{
  using namespace dealii;

  namespace
  {
    /// Collects what goes to std::cerr as long as it lives: deal.II writes
    /// there what is wrong with an expression, beside the exception.
    class CapturedErrors
    {
    public:
      CapturedErrors()
        : original(std::cerr.rdbuf(text.rdbuf()))
      {}

      ~CapturedErrors()
      {
        std::cerr.rdbuf(original);
      }

      /// " (reason)", or nothing if no reason was given.
      std::string
      reason() const
      {
        const std::string all = text.str(), mark = "Message:  <";
        const auto        begin = all.find(mark), end = all.find(">\n", begin);
        if (begin == std::string::npos || end == std::string::npos)
          return "";
        const auto first = begin + mark.size();
        return " (" + all.substr(first, end - first) + ")";
      }

    private:
      std::ostringstream text;
      std::streambuf    *original;
    };
  } // namespace



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
    const CapturedErrors errors;
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
                         text + "'" + errors.reason() + ".");
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
