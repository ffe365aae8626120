#ifndef mpm_granular_observables_observables_table_h
#define mpm_granular_observables_observables_table_h

#include <mpm_granular/observables/observable.h>

#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace mpm_granular::Observables
{
  /**
   * The columns every table begins with, in this order: what programs that read
   * observables.csv rely on. Columns of further observables come after them.
   */
  const std::vector<std::string> &
  standard_columns();

  /// All registered observables, written to observables.csv row by row.
  template <int dim>
  class ObservablesTable : public Parameters::ParameterGroup
  {
  public:
    ObservablesTable();

    /// Entries of the current subsection: the run-out direction and those of
    /// every observable.
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// The names of all columns in the order of the table.
    const std::vector<std::string> &
    columns() const
    {
      return names;
    }

    /// Opens the file @p path and writes the line of names.
    /// @throws InputError if it cannot be written.
    void
    open(const std::string &path);

    /// Opens the file @p path of an interrupted run, cuts off the rows after
    /// those that serialize() knows of, and goes on there.
    /// @throws InputError if it cannot be read and written, has other columns
    /// or fewer rows.
    void
    reopen(const std::string &path);

    /// What the table and its observables remember, for checkpoints.
    void
    serialize(Core::Archive &archive);

    /// Evaluates all observables and appends a row, which is in the file when
    /// this returns. Without an open file it is only evaluated.
    /// @throws ComputationError if the file cannot be written.
    void
    write(const Snapshot<dim> &snapshot);

    /// The value of column @p name in the last row.
    double
    last(const std::string &name) const;

    /// The final surface as a table of position and height, as text (CSV), in
    /// bins of one mean cell size.
    std::string
    profile_text(const Snapshot<dim> &snapshot) const;

  private:
    /// The line of names.
    std::string
    header() const;

    /// Position of column @p name in the table.
    unsigned int
    column_index(const std::string &name) const;

    std::string                                   run_out = "x";
    std::vector<std::unique_ptr<Observable<dim>>> observables;
    std::vector<std::string>                      names;
    std::vector<double>                           row;
    std::ofstream                                 file;
    std::uint64_t                                 n_rows = 0; ///< in the file
  };
} // namespace mpm_granular::Observables

#endif
