#include <deal.II/base/config.h>

#include <unistd.h>

#include <mpm_granular/core/version.h>
#include <mpm_granular/output/json.h>
#include <mpm_granular/output/manifest.h>
#include <mpm_granular/output/run_folder.h>

#include <ctime>

namespace mpm_granular::Output
{
  namespace
  {
    /// Now, in universal time: 2024-01-31T12:00:00Z.
    std::string
    time_stamp()
    {
      const std::time_t now = std::time(nullptr);
      std::tm           parts;
      ::gmtime_r(&now, &parts);
      char buffer[32];
      std::strftime(buffer, sizeof(buffer), "%Y-%m-%dT%H:%M:%SZ", &parts);
      return buffer;
    }



    std::string
    host_name()
    {
      char name[256] = "";
      return ::gethostname(name, sizeof(name) - 1) == 0 ? name : "unknown";
    }



    std::string
    outcome_name(const Manifest::Outcome outcome)
    {
      switch (outcome)
        {
          case Manifest::Outcome::running:
            return "running";
          case Manifest::Outcome::done:
            return "done";
          case Manifest::Outcome::failed:
            return "failed";
          case Manifest::Outcome::interrupted:
            return "interrupted";
        }
      return "unknown";
    }
  } // namespace



  std::string
  command_text(const int argc, const char *const *argv)
  {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUV"
                              "WXYZ0123456789_-./=:,+@%";
    std::string       text;
    for (int i = 0; i < argc; ++i)
      {
        const std::string argument = argv[i];
        text += i > 0 ? " " : "";
        if (!argument.empty() &&
            argument.find_first_not_of(plain) == std::string::npos)
          text += argument;
        else
          {
            text += '\'';
            for (const char character : argument)
              if (character == '\'')
                text += "'\\''";
              else
                text += character;
            text += '\'';
          }
      }
    return text;
  }



  Manifest::Manifest(const std::string &command, const unsigned int n_ranks)
    : command(command)
    , n_ranks(n_ranks)
    , start_time(time_stamp())
    , outcome(Outcome::running)
  {}



  void
  Manifest::end(const Outcome how, const std::string &why)
  {
    outcome  = how;
    message  = why;
    end_time = time_stamp();
  }



  std::string
  Manifest::text() const
  {
    JsonObject build;
    build.add("version", Core::version)
      .add("git_hash", Core::git_hash)
      .add("compiler", Core::compiler)
      .add("build_type", Core::build_type)
      .add("deal_ii_version", DEAL_II_PACKAGE_VERSION);

    JsonObject counts;
    counts.add("cells", n_cells)
      .add("nodes", n_nodes)
      .add("points", n_points)
      .add("lost_points", n_lost_points)
      .add("steps", n_steps)
      .add("point_steps", n_point_steps)
      .add("point_files", n_files);

    JsonObject performance;
    performance.add("set_up_seconds", set_up_time)
      .add("loop_seconds", loop_time)
      .add("million_point_steps_per_second", throughput)
      .add("bytes_per_point", bytes_per_point)
      .add("peak_memory_bytes", peak_memory)
      .add("messages_per_step", messages_per_step)
      .add("bytes_sent_per_step", bytes_sent_per_step)
      .add("redistributions", n_redistributions)
      .add("largest_imbalance", largest_imbalance)
      .add("adaptations", n_adaptations)
      .add("adaptation_seconds", adaptation_time);

    JsonObject manifest;
    manifest.add("program", "mpm_granular")
      .add("build", build)
      .add("command", command)
      .add("host", host_name())
      .add("ranks", n_ranks)
      .add("dimension", dimension)
      .add("start", start_time)
      .add("end", end_time)
      .add("outcome", outcome_name(outcome))
      .add("message", message)
      .add("resumed", resumed)
      .add("simulated_time", simulated_time)
      .add("counts", counts)
      .add("performance", performance)
      .add("warnings", warnings);
    return manifest.text() + "\n";
  }



  void
  Manifest::write(const std::string &path) const
  {
    write_atomically(path, [this](std::ostream &out) { out << text(); });
  }
} // namespace mpm_granular::Output
