#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/observables/observables_table.h>
#include <mpm_granular/observables/surface.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

namespace mpm_granular::Observables
{
  using namespace dealii;

  const std::vector<std::string> &
  standard_columns()
  {
    static const std::vector<std::string> columns{"time",
                                                  "step",
                                                  "dt",
                                                  "points",
                                                  "mass",
                                                  "front",
                                                  "height",
                                                  "center_x",
                                                  "center_y",
                                                  "center_z",
                                                  "kinetic_energy",
                                                  "elastic_energy",
                                                  "potential_energy",
                                                  "dissipated_energy",
                                                  "boundary_work",
                                                  "transfer_loss",
                                                  "lost_points",
                                                  "closure",
                                                  "area",
                                                  "max_speed"};
    return columns;
  }



  template <int dim>
  ObservablesTable<dim>::ObservablesTable()
    : names(standard_columns())
  {
    unsigned int n_columns = 0;
    for (const auto &[name, record] : ObservableRegistry<dim>::records())
      {
        observables.push_back(record.make());
        for (const auto &column : observables.back()->columns())
          {
            ++n_columns;
            if (std::find(names.begin(), names.end(), column) == names.end())
              names.push_back(column);
          }
      }
    AssertThrow(n_columns == names.size(),
                ExcMessage("Two observables write the same column, or a "
                           "standard column is not written by any."));
    row.resize(names.size(), std::numeric_limits<double>::quiet_NaN());
  }



  template <int dim>
  void
  ObservablesTable<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Run-out direction",
                      run_out,
                      "Direction in which the body is expected to flow: front, "
                      "area and profile are measured along it, heights against "
                      "gravity.",
                      Patterns::Selection(Frame<dim>::directions()));
    for (const auto &observable : observables)
      observable->add_parameters(prm);
  }



  template <int dim>
  void
  ObservablesTable<dim>::check() const
  {
    for (const auto &observable : observables)
      observable->check();
  }



  template <int dim>
  void
  ObservablesTable<dim>::open(const std::string &path)
  {
    file.open(path);
    file << header() << std::endl;
    require(file.good(), "The table '" + path + "' cannot be written.");
  }



  template <int dim>
  void
  ObservablesTable<dim>::reopen(const std::string &path)
  {
    std::ifstream table(path, std::ios::binary);
    std::string   line;
    std::getline(table, line);
    require(table.good(), "The table '" + path + "' cannot be read.");
    require(line == header(),
            "The table '" + path +
              "' has other columns than this version of the program writes.");
    for (std::uint64_t row = 0; row < n_rows; ++row)
      {
        std::getline(table, line);
        // At the end of the file where a line break is missing.
        require(table.good(),
                "The table '" + path + "' has fewer than the " +
                  std::to_string(n_rows) +
                  " rows that were there when the checkpoint was written.");
      }
    const std::uintmax_t size = table.tellg();
    table.close();

    std::error_code error;
    std::filesystem::resize_file(path, size, error);
    file.open(path, std::ios::app);
    require(!error && file.is_open(),
            "The table '" + path + "' cannot be written.");
  }



  template <int dim>
  void
  ObservablesTable<dim>::serialize(Core::Archive &archive)
  {
    archive.replicated("observables/n_rows", n_rows);
    for (const auto &observable : observables)
      observable->serialize(archive);
  }



  template <int dim>
  std::string
  ObservablesTable<dim>::header() const
  {
    std::string line;
    for (const auto &name : names)
      line += (line.empty() ? "" : ",") + name;
    return line;
  }



  template <int dim>
  void
  ObservablesTable<dim>::write(const Snapshot<dim> &snapshot)
  {
    const Frame<dim> frame(snapshot.mesh, run_out, snapshot.gravity);
    for (const auto &observable : observables)
      {
        const auto columns = observable->columns();
        const auto values  = observable->values(snapshot, frame);
        AssertDimension(columns.size(), values.size());
        for (unsigned int c = 0; c < columns.size(); ++c)
          row[column_index(columns[c])] = values[c];
      }

    if (!file.is_open())
      return;
    std::string line;
    for (unsigned int c = 0; c < row.size(); ++c)
      line += (c == 0 ? "" : ",") + Core::exact_text(row[c]);
    file << line + "\n" << std::flush;
    ++n_rows;
    if (!file)
      throw ComputationError("A row of observables.csv cannot be written. Is "
                             "there space on the disk?");
  }



  template <int dim>
  double
  ObservablesTable<dim>::last(const std::string &name) const
  {
    return row[column_index(name)];
  }



  template <int dim>
  std::string
  ObservablesTable<dim>::profile_text(const Snapshot<dim> &snapshot) const
  {
    const Frame<dim> frame(snapshot.mesh, run_out, snapshot.gravity);
    const Surface    surface = find_surface(snapshot.points,
                                         snapshot.communicator,
                                         frame,
                                         snapshot.mesh.mean_cell_size());
    std::string      text    = "x,height\n";
    for (unsigned int bin = 0; bin < surface.height.size(); ++bin)
      text += Core::exact_text(surface.position(bin)) + "," +
              Core::exact_text(surface.height[bin]) + "\n";
    return text;
  }



  template <int dim>
  unsigned int
  ObservablesTable<dim>::column_index(const std::string &name) const
  {
    const auto column = std::find(names.begin(), names.end(), name);
    AssertThrow(column != names.end(),
                ExcMessage("There is no column '" + name + "'."));
    return column - names.begin();
  }



  template class ObservablesTable<2>;
  template class ObservablesTable<3>;
} // namespace mpm_granular::Observables
