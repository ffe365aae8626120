#include <sys/ioctl.h>
#include <unistd.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/console.h>

#include <iostream>

namespace mpm_granular::Output
{
  namespace
  {
    /// Columns of the terminal on standard output.
    unsigned int
    terminal_width()
    {
      winsize size = {};
      return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ?
               size.ws_col :
               80;
    }



    std::string
    with_line_break(const std::string &text)
    {
      return text.empty() || text.back() != '\n' ? text + "\n" : text;
    }
  } // namespace



  Console::Console(std::ostream &screen,
                   const bool    is_terminal,
                   const bool    is_active)
    : screen(screen)
    , is_terminal(is_terminal)
    , is_active(is_active)
    , line_is_renewed(false)
  {}



  Console::Console(const bool is_active)
    : Console(std::cout, ::isatty(STDOUT_FILENO) == 1, is_active)
  {}



  Console::~Console()
  {
    clear_renewed_line();
  }



  void
  Console::open_log(const std::string &path, const bool append)
  {
    if (!is_active)
      return;
    log_file.open(path, append ? std::ios::app : std::ios::trunc);
    require(log_file.is_open(),
            "The log file '" + path + "' cannot be written.");
    log_file << unlogged << std::flush;
    unlogged.clear();
  }



  void
  Console::say(const std::string &text)
  {
    if (!is_active)
      return;
    clear_renewed_line();
    screen << with_line_break(text) << std::flush;
    log(text);
  }



  void
  Console::renew(const std::string &line)
  {
    if (!has_terminal())
      return;
    // A line that wraps could not be taken back: cut it to the width.
    screen << '\r' << line.substr(0, terminal_width() - 1) << "\033[K"
           << std::flush;
    line_is_renewed = true;
  }



  void
  Console::log(const std::string &text)
  {
    if (!is_active)
      return;
    if (log_file.is_open())
      log_file << with_line_break(text) << std::flush;
    else
      unlogged += with_line_break(text);
  }



  void
  Console::clear_renewed_line()
  {
    if (line_is_renewed)
      screen << "\r\033[K" << std::flush;
    line_is_renewed = false;
  }
} // namespace mpm_granular::Output
