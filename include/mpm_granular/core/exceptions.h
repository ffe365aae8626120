#ifndef mpm_granular_core_exceptions_h
#define mpm_granular_core_exceptions_h

#include <stdexcept>
#include <string>

namespace mpm_granular
{
  /**
   * The input is refused: a parameter, a file, or a combination of them cannot
   * be right. Nothing has been computed or written. The program ends with exit
   * code 1. The message names the parameter or the file and line, what is
   * allowed and what was given.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The computation failed: a value that is not a number, an inverted volume, a
   * point outside the mesh, a collapsed time step. The program writes a last
   * output and ends with exit code 2. The message gives reason, point and
   * place, and what to try.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * Throws InputError with @p message unless @p condition holds: for checks of
   * user input, always active, unlike Assert.
   */
  inline void
  require(const bool condition, const std::string &message)
  {
    if (!condition)
      throw InputError(message);
  }
} // namespace mpm_granular

#endif
