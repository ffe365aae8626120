#ifndef mpm_granular_output_console_h
#define mpm_granular_output_console_h

#include <fstream>
#include <ostream>
#include <string>

namespace mpm_granular::Output
{
  /**
   * What the program says: on the screen, and into the log file of the run.
   * What is said before the log is opened is kept for it.
   */
  class Console
  {
  public:
    /**
     * @param screen where to say it.
     * @param is_terminal whether @p screen can renew its last line.
     * @param is_active false on all MPI processes but the first: says nothing.
     */
    Console(std::ostream &screen, const bool is_terminal, const bool is_active);

    /// The console on standard output; a terminal if that is one.
    explicit Console(const bool is_active);

    ~Console();

    /// Opens the log file @p path and writes into it what was said so far.
    /// @param append whether what is in the file stays.
    void
    open_log(const std::string &path, const bool append = false);

    /// Says @p text, one or more lines; the last line break is added if it is
    /// missing.
    void
    say(const std::string &text);

    /// Puts @p line in place of the renewed line on a terminal. Otherwise
    /// nothing.
    void
    renew(const std::string &line);

    /// Writes @p text to the log only.
    void
    log(const std::string &text);

    bool
    has_terminal() const
    {
      return is_terminal && is_active;
    }

  private:
    /// Takes the renewed line off the terminal.
    void
    clear_renewed_line();

    std::ostream &screen;
    const bool    is_terminal;
    const bool    is_active;
    bool          line_is_renewed;
    std::ofstream log_file;
    std::string   unlogged;
  };
} // namespace mpm_granular::Output

#endif
