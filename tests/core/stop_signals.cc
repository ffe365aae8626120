// The first signal only asks to stop, the second one ends the program. SIGUSR1
// asks for one checkpoint, however often it came.

#include <sys/wait.h>
#include <unistd.h>

#include <mpm_granular/core/signals.h>

#include <csignal>
#include <iostream>

using namespace mpm_granular;

int
main()
{
  const pid_t child = fork();
  if (child == 0)
    {
      Core::catch_signals();
      if (Core::stop_requested() || Core::take_checkpoint_request())
        _exit(1);
      raise(SIGUSR1);
      raise(SIGUSR1);
      if (!Core::take_checkpoint_request() || Core::take_checkpoint_request() ||
          Core::stop_requested())
        _exit(4);
      raise(SIGINT);
      if (!Core::stop_requested() || Core::stop_signal() != SIGINT)
        _exit(2);
      raise(SIGTERM);
      _exit(3);
    }
  int status = 0;
  waitpid(child, &status, 0);
  std::cout << "Ended by the second signal: "
            << (WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM)
            << std::endl;
}
