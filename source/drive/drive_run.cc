#include <deal.II/base/array_view.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/drive/drive_run.h>
#include <mpm_granular/drive/yield_line.h>
#include <mpm_granular/materials/stress_update.h>
#include <mpm_granular/output/console.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace mpm_granular::Drive
{
  using namespace dealii;

  namespace
  {
    Stress<3>
    stress_of(const Points::PointArrays<3> &point)
    {
      Stress<3> stress;
      for (unsigned int c = 0; c < n_stress<3>; ++c)
        stress[c] = point.stress[c][0];
      return stress;
    }



    template <class Cell>
    void
    write_line(std::ostream &file, const std::vector<Cell> &cells)
    {
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          file << (c == 0 ? "" : ",");
          if constexpr (std::is_same_v<Cell, double>)
            file << Core::exact_text(cells[c]);
          else
            file << cells[c];
        }
      file << '\n';
    }
  } // namespace



  DriveRun::DriveRun(const DriveParameters     &parameters,
                     const Parameters::RunInfo &info)
    : parameters(parameters)
    , info(info)
    , folder(parameters.directory, info.overwrite || info.check_only)
    , law(*parameters.tested_material().law)
    , loading(loading_of(parameters.test))
  {
    point.resize(1, law.history_names().size());
    point.volume[0] = 1.;
    for (unsigned int c = 0; c < 3; ++c)
      initial_stress[c] = parameters.initial_stress[c];
    for (unsigned int c = 0; c < n_stress<3>; ++c)
      point.stress[c][0] = initial_stress[c];
    law.initialize(point, {0, 1});
  }



  void
  DriveRun::execute()
  {
    Output::Console console(
      Utilities::MPI::this_mpi_process(info.communicator) == 0);
    console.say("Test of one material point: " + parameters.test + ", " +
                std::to_string(parameters.n_steps) + " steps.");
    if (const std::string remark = law.remark_on(initial_stress);
        !remark.empty())
      console.say("Warning: " + remark);
    if (info.check_only)
      return;

    try
      {
        compute();
      }
    catch (const ComputationError &)
      {
        write_files();
        throw;
      }
    write_files();
    console.say("Results in " + folder.path());
  }



  void
  DriveRun::write_files() const
  {
    const auto names = columns();
    const auto p = std::find(names.begin(), names.end(), "p") - names.begin();
    const auto by_pressure = [p](const auto &one, const auto &other) {
      return one[p] < other[p];
    };
    const double highest =
      std::max(0.,
               (*std::max_element(rows.begin(), rows.end(), by_pressure))[p]);
    // Also where there is tension, if the law bears any.
    const auto line =
      yield_line(law, loading.deviator, -.25 * highest, 1.05 * highest);

    Output::on_first_rank(info.communicator, [&] {
      folder.prepare();
      Output::write_atomically(folder.file("parameters.prm"),
                               [&](std::ostream &file) {
                                 file << info.parameter_text;
                               });
      Output::write_atomically(folder.file("drive.csv"),
                               [&](std::ostream &file) {
                                 write_line(file, names);
                                 for (const auto &row : rows)
                                   write_line(file, row);
                               });
      Output::write_atomically(
        folder.file("yield.csv"), [&](std::ostream &file) {
          write_line(file, std::vector<std::string>{"p", "q"});
          for (const auto &[pressure, q] : line)
            write_line(file, std::vector<double>{pressure, q});
        });
    });
  }



  std::vector<std::string>
  DriveRun::columns() const
  {
    std::vector<std::string> names{"time", "strain"};
    for (const std::string kind : {"strain_", "stress_"})
      for (const auto *component : stress_name)
        names.push_back(kind + component);
    names.insert(names.end(), {"p", "q", "volumetric_strain"});
    for (const auto &name : law.history_names())
      names.push_back(name);
    names.push_back("dissipated_energy");
    return names;
  }



  void
  DriveRun::add_row()
  {
    const Stress<3>     stress = stress_of(point);
    std::vector<double> row{time, strain};
    row.insert(row.end(), strain_tensor.begin(), strain_tensor.end());
    row.insert(row.end(), stress.begin(), stress.end());
    row.push_back(Materials::pressure(stress));
    row.push_back(Materials::equivalent_stress(stress));
    row.push_back(std::log(point.volume[0]));
    for (const auto &slot : point.history)
      row.push_back(slot[0]);
    row.push_back(dissipated);
    rows.push_back(row);
  }



  void
  DriveRun::compute()
  {
    add_row();
    double length = 0., before = 0.;
    for (const double end : parameters.strains)
      {
        length += std::abs(end - before);
        before = end;
      }
    before              = 0.;
    double       way    = 0.;
    unsigned int n_done = 0;
    for (const double end : parameters.strains)
      {
        way += std::abs(end - before);
        const unsigned int n_until_here = std::max<unsigned int>(
          n_done + 1, std::lround(parameters.n_steps * way / length));
        const unsigned int n_steps = n_until_here - n_done;
        for (unsigned int n = 1; n < n_steps; ++n)
          advance(before + n * (end - before) / n_steps);
        advance(end);
        before = end;
        n_done = n_until_here;
      }
  }



  std::pair<Points::PointArrays<3>, double>
  DriveRun::after_step(const double trial_adjustment,
                       const double strain_increment) const
  {
    auto         moved = point;
    const double time_step =
      std::abs(strain_increment) / parameters.strain_rate;
    const Tensor<2, 3> gradient =
      strain_increment / time_step *
      (loading.driven + trial_adjustment * loading.adjusted);
    const Points::Run run{0, 1};
    const double      released =
      Materials::update_stress<3>(law,
                                  moved,
                                  make_array_view(&run, &run + 1),
                                  make_array_view(&gradient, &gradient + 1),
                                  time_step);
    return {std::move(moved), released};
  }



  double
  DriveRun::find_adjustment(const double strain_increment) const
  {
    using Keeps = Loading::Keeps;
    if (loading.keeps == Keeps::nothing)
      return 0.;
    // What is to be kept less what it was; the sign of the strain makes it grow
    // with the adjustment.
    const double sign   = strain_increment > 0. ? 1. : -1.;
    const auto   excess = [&](const double trial) {
      const auto moved = after_step(trial, strain_increment).first;
      return sign * (loading.keeps == Keeps::volume ?
                         moved.volume[0] - 1. :
                         moved.stress[loading.component][0] -
                         initial_stress[loading.component]);
    };

    // A bracket around the adjustment of the last step.
    double       lower = adjustment, upper = adjustment;
    double       at_lower = excess(lower), at_upper = at_lower;
    const double farthest = .5 / std::abs(strain_increment);
    for (double width = 1e-3; at_lower > 0. && width < farthest; width *= 2.)
      at_lower = excess(lower = adjustment - width);
    for (double width = 1e-3; at_upper < 0. && width < farthest; width *= 2.)
      at_upper = excess(upper = adjustment + width);
    if (at_lower == 0.)
      return lower;
    if (at_upper == 0.)
      return upper;
    if (!(at_lower < 0. && at_upper > 0.))
      {
        std::ostringstream text;
        text << "At the strain " << strain << " no lateral strain keeps the "
             << (loading.keeps == Keeps::volume ?
                   std::string("volume") :
                   std::string("stress ") + stress_name[loading.component])
             << " at what it was in the beginning. Does the material bear the "
                "initial stress? Try more steps.";
        throw ComputationError(text.str());
      }
    const boost::math::tools::eps_tolerance<double> tolerance(50);
    std::uintmax_t                                  n_iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(
      excess, lower, upper, at_lower, at_upper, tolerance, n_iterations);
    return .5 * (bracket.first + bracket.second);
  }



  void
  DriveRun::advance(const double next_strain)
  {
    const double strain_increment = next_strain - strain;
    adjustment                    = find_adjustment(strain_increment);
    auto [moved, released]        = after_step(adjustment, strain_increment);
    point                         = std::move(moved);
    dissipated += released;
    time += std::abs(strain_increment) / parameters.strain_rate;
    strain = next_strain;
    const Tensor<2, 3> increment =
      strain_increment * (loading.driven + adjustment * loading.adjusted);
    for (unsigned int c = 0; c < n_stress<3>; ++c)
      {
        const auto [i, j] = stress_index[c];
        strain_tensor[c] += .5 * (increment[i][j] + increment[j][i]);
      }
    if (!std::isfinite(Materials::equivalent_stress(stress_of(point))))
      {
        std::ostringstream text;
        text << "At the strain " << strain
             << " the stress is no number. Try more steps.";
        throw ComputationError(text.str());
      }
    add_row();
  }
} // namespace mpm_granular::Drive
