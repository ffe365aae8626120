#include <mpm_granular/output/number_text.h>
#include <mpm_granular/output/preflight.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Output
{
  namespace
  {
    /// Lines of "label   value", the labels in one column.
    class Table
    {
    public:
      /// @p value is left out with its line if it is not known.
      void
      add(const std::string &label,
          const double       known,
          const std::string &value)
      {
        constexpr unsigned int width = 22;
        if (!std::isnan(known))
          lines +=
            "  " + label +
            std::string(width - std::min<std::size_t>(width, label.size()),
                        ' ') +
            value + "\n";
      }

      void
      add_heading(const std::string &heading)
      {
        lines += heading + "\n";
      }

      std::string lines;
    };
  } // namespace



  double
  Preflight::mean_points_per_cell() const
  {
    return n_filled_cells > 0 ? static_cast<double>(n_points) / n_filled_cells :
                                unknown;
  }



  double
  Preflight::n_steps() const
  {
    return std::ceil(end_time / chosen_dt - 1e-9);
  }



  double
  Preflight::wall_time() const
  {
    return n_steps() * n_points / (1e6 * throughput * n_ranks);
  }



  void
  Preflight::add_warnings()
  {
    if (chosen_dt > stable_dt)
      warnings.push_back("The time step " + short_text(chosen_dt) +
                         " s is above the stability limit " +
                         short_text(stable_dt) + " s: the run may blow up.");
    if (chosen_dt < 0.02 * stable_dt)
      warnings.push_back(
        "The time step " + short_text(chosen_dt) + " s is " +
        count_text(std::round(stable_dt / chosen_dt)) +
        " times below the stability limit; the run takes that much longer.");
    if (mean_points_per_cell() < 4. && averaging != "nodes")
      warnings.push_back(
        "Filled cells hold " + short_text(mean_points_per_cell()) +
        " points on average. Below 4 the body may fall apart numerically, but "
        "with Scheme/Averaging = nodes on simplices.");
    if (n_files * bytes_per_file > 20e9)
      warnings.push_back("The points' files will need about " +
                         bytes_text(n_files * bytes_per_file) + " of disk.");
  }



  std::string
  Preflight::text() const
  {
    const bool        plane       = dimension == 2;
    const std::string mass_unit   = plane ? " kg/m" : " kg";
    const std::string volume_unit = plane ? " m^2" : " m^3";
    Table             table;

    table.add_heading("Mesh");
    table.add("dimension", dimension, std::to_string(dimension));
    table.add("cells", n_cells, count_text(n_cells));
    table.add("nodes", n_nodes, count_text(n_nodes));
    table.add("mean cell size",
              mean_cell_size,
              short_text(mean_cell_size) + " m");
    table.add("smallest altitude",
              min_altitude,
              short_text(min_altitude) + " m");

    table.add_heading("Points");
    table.add("points", n_points, count_text(n_points));
    table.add("filled cells", n_filled_cells, count_text(n_filled_cells));
    table.add("points a filled cell",
              mean_points_per_cell(),
              "mean " + short_text(mean_points_per_cell()) + ", min " +
                short_text(min_points_per_cell) + ", max " +
                short_text(max_points_per_cell));
    table.add("mass", mass, short_text(mass, 6) + mass_unit);
    table.add("filled volume", volume, short_text(volume, 6) + volume_unit);

    table.add_heading("Materials");
    for (const auto &material : materials)
      table.add(material.name,
                material.density,
                material.law + ", density " + short_text(material.density, 4) +
                  " kg/m^3, wave speed " + short_text(material.wave_speed, 4) +
                  " m/s, " + count_text(material.n_points) + " points");

    table.add_heading("Scheme");
    table.add("averaging", n_points, averaging);
    const auto add_rate = [&](const std::string &label, const double rate) {
      if (rate > 0.)
        table.add(label, rate, short_text(rate) + "/s");
    };
    add_rate("pressure filter", pressure_filter_rate);
    add_rate("position shift", position_shift_rate);

    table.add_heading("Time");
    table.add("gravity", gravity, short_text(gravity, 4) + " m/s^2");
    table.add("end", end_time, short_text(end_time, 4) + " s");
    table.add("stability limit", stable_dt, short_text(stable_dt) + " s");
    table.add("time step",
              chosen_dt,
              short_text(chosen_dt) + " s (" +
                short_text(chosen_dt / stable_dt, 2) + " of the limit)");
    table.add("steps", n_steps(), "about " + count_text(n_steps()));

    table.add_heading("Cost");
    if (n_ranks > 1)
      table.add("processes", n_ranks, count_text(n_ranks));
    table.add("wall time",
              wall_time(),
              "about " + duration_text(wall_time()) + " at " +
                short_text(throughput * n_ranks) + " million point-steps/s");
    table.add("memory",
              bytes_in_memory,
              "about " + bytes_text(bytes_in_memory));
    table.add("disk",
              n_files * bytes_per_file,
              "about " + bytes_text(n_files * bytes_per_file) + " in " +
                count_text(n_files) + " files of points");

    std::string text = table.lines;
    for (const auto &warning : warnings)
      text += "Warning: " + warning + "\n";
    return text;
  }
} // namespace mpm_granular::Output
