#ifndef mpm_granular_core_signals_h
#define mpm_granular_core_signals_h

namespace mpm_granular::Core
{
  /**
   * From now on, a first SIGINT or SIGTERM only makes stop_requested() true, so
   * that the run can end after the current step with its state written; a
   * second one ends the program at once. SIGUSR1 asks for a checkpoint.
   */
  void
  catch_signals();

  /// The number of the signal that asked to stop, 0 if there was none.
  int
  stop_signal();

  /// Whether a signal asked to stop. Cheap: may be called every step.
  inline bool
  stop_requested()
  {
    return stop_signal() != 0;
  }

  /// Whether SIGUSR1 came since the last call.
  bool
  take_checkpoint_request();
} // namespace mpm_granular::Core

#endif
