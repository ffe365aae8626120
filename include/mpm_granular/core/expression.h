#ifndef mpm_granular_core_expression_h
#define mpm_granular_core_expression_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace mpm_granular::Core
{
  /**
   * Functions of place and time from the parameter file: expressions separated
   * by semicolons, in the variables x, y, z and t [m, s] and the constant pi.
   */
  template <int dim>
  class Expression
  {
  public:
    /**
     * @param text the expressions.
     * @param n_components how many there must be.
     * @param entry name of the entry, for messages.
     * @throws InputError if @p text cannot be understood.
     */
    Expression(const std::string &text,
               const unsigned int n_components,
               const std::string &entry);

    double
    value(const dealii::Point<dim> &place,
          const double              time,
          const unsigned int        component = 0) const;

  private:
    std::shared_ptr<dealii::FunctionParser<dim>> parser;
  };
} // namespace mpm_granular::Core

#endif
