#ifndef mpm_granular_output_schedule_h
#define mpm_granular_output_schedule_h

namespace mpm_granular::Output
{
  /**
   * Instants at equal distances from a start: when to write. Instants are
   * counted, not added up, so that they are free of accumulated round-off.
   */
  class Schedule
  {
  public:
    /**
     * @param interval distance of instants [s]; 0: none, next() is infinite.
     * @param start the last instant that is over [s].
     */
    explicit Schedule(const double interval, const double start = 0.);

    /// The next instant [s], for a time step to end on.
    double
    next() const;

    /**
     * Whether @p time [s] has reached the next instant, up to round-off. If so,
     * all instants up to it count as over.
     */
    bool
    passes(const double time);

  private:
    double       interval;
    double       start;
    unsigned int n_passed;
  };
} // namespace mpm_granular::Output

#endif
