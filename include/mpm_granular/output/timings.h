#ifndef mpm_granular_output_timings_h
#define mpm_granular_output_timings_h

#include <chrono>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// Wall time by section of the program: a stopwatch a section.
  class Timings
  {
  public:
    /// Index of the section @p name, which is made if it is new. Do this once,
    /// outside of loops.
    unsigned int
    section(const std::string &name);

    /// Runs from its construction to its destruction.
    class Scope
    {
    public:
      Scope(Timings &timings, const unsigned int section);
      ~Scope();
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      Timings                              &timings;
      const unsigned int                    section;
      std::chrono::steady_clock::time_point begin;
    };

    /// Wall time spent in @p section so far [s].
    double
    seconds(const unsigned int section) const;

    /**
     * A table of all sections with calls, time and share.
     *
     * @param total wall time that is 100 % [s]; what no section covers is shown
     *   as "other".
     */
    std::string
    table(const double total) const;

  private:
    struct Record
    {
      std::string  name;
      double       seconds = 0.;
      unsigned int n_calls = 0;
    };

    std::vector<Record> records;
  };
} // namespace mpm_granular::Output

#endif
