#ifndef mpm_granular_output_manifest_h
#define mpm_granular_output_manifest_h

#include <cstdint>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// The command line as one text that a shell reads back.
  std::string
  command_text(const int argc, const char *const *argv);

  /**
   * What a run was: enough to repeat it, and to know how it ended. Written when
   * the run starts and again when it ends; a run that was killed is left with
   * the outcome "running".
   */
  class Manifest
  {
  public:
    /// How a run ended.
    enum class Outcome
    {
      running,
      done,
      failed,
      interrupted
    };

    /**
     * The start is now.
     *
     * @param command the command line, see command_text().
     * @param n_ranks number of MPI processes.
     */
    Manifest(const std::string &command, const unsigned int n_ranks);

    unsigned int  dimension     = 0;
    std::uint64_t n_cells       = 0; ///< now
    std::uint64_t n_nodes       = 0; ///< now
    std::uint64_t n_points      = 0; ///< at the start
    std::uint64_t n_lost_points = 0;
    std::uint64_t n_steps       = 0;
    std::uint64_t n_point_steps = 0;
    unsigned int  n_files       = 0; ///< VTU files of points

    double simulated_time      = 0.; ///< [s]
    double messages_per_step   = 0.; ///< sums over nodes, of the busiest rank
    double bytes_sent_per_step = 0.; ///< sums over nodes, of the busiest rank
    double largest_imbalance = 0.; ///< most points of a rank over mean, less 1
    unsigned int n_redistributions = 0;  ///< of cells among the ranks
    unsigned int n_adaptations     = 0;  ///< of the mesh
    double       adaptation_time   = 0.; ///< wall time of these [s]
    double       set_up_time     = 0.; ///< wall time of making mesh and points
    double       loop_time       = 0.; ///< wall time without output [s]
    double       peak_memory     = 0.; ///< of all processes [bytes]
    double       throughput      = 0.; ///< million point-steps/s
    double       bytes_per_point = 0.;

    /// Where the run was continued from, each time.
    std::vector<std::string> resumed;

    /// Warnings that the user was shown.
    std::vector<std::string> warnings;

    /**
     * Notes the end of the run, which is now.
     *
     * @param outcome how it ended.
     * @param message why, if it did not end as planned.
     */
    void
    end(const Outcome outcome, const std::string &message = "");

    /// Writes the file @p path atomically.
    void
    write(const std::string &path) const;

    /// What write() writes.
    std::string
    text() const;

  private:
    std::string  command;
    unsigned int n_ranks;
    std::string  start_time;
    std::string  end_time;
    Outcome      outcome;
    std::string  message;
  };
} // namespace mpm_granular::Output

#endif
