#include <mpm_granular/core/signals.h>

#include <atomic>
#include <csignal>

namespace mpm_granular::Core
{
  namespace
  {
    std::atomic<int>  received_signal{0};
    std::atomic<bool> checkpoint_is_wanted{false};
    static_assert(std::atomic<int>::is_always_lock_free,
                  "a signal handler may use lock-free atomics only");
    static_assert(std::atomic<bool>::is_always_lock_free,
                  "a signal handler may use lock-free atomics only");

    extern "C" void
    receive_stop_signal(const int signal_number)
    {
      if (received_signal.exchange(signal_number) != 0)
        {
          std::signal(signal_number, SIG_DFL);
          std::raise(signal_number);
        }
    }

    extern "C" void
    receive_checkpoint_signal(const int)
    {
      checkpoint_is_wanted = true;
    }
  } // namespace



  void
  catch_signals()
  {
    std::signal(SIGINT, receive_stop_signal);
    std::signal(SIGTERM, receive_stop_signal);
    std::signal(SIGUSR1, receive_checkpoint_signal);
  }



  int
  stop_signal()
  {
    return received_signal.load(std::memory_order_relaxed);
  }



  bool
  take_checkpoint_request()
  {
    return checkpoint_is_wanted.load(std::memory_order_relaxed) &&
           checkpoint_is_wanted.exchange(false);
  }
} // namespace mpm_granular::Core
