#ifndef mpm_granular_parameters_dimension_h
#define mpm_granular_parameters_dimension_h

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/parameters/input_text.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * Declares the entry "Dimension", with 3 as its default and @p dim as its
   * value. Its value is read before those of all other entries with
   * read_dimension(), since their types depend on it.
   */
  void
  declare_dimension(dealii::ParameterHandler &prm, const unsigned int dim);

  /**
   * Reads only the entry "Dimension" and passes over all else.
   *
   * @param source the parameter file; without a name: none.
   * @param overrides "Section/Sub/Entry=value", stronger than the file.
   * @return 2 or 3.
   * @throws InputError if the value is none of them.
   */
  unsigned int
  read_dimension(const InputSource              &source,
                 const std::vector<std::string> &overrides);
} // namespace mpm_granular::Parameters

#endif
