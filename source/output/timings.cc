#include <mpm_granular/output/number_text.h>
#include <mpm_granular/output/timings.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace mpm_granular::Output
{
  unsigned int
  Timings::section(const std::string &name)
  {
    const auto record =
      std::find_if(records.begin(), records.end(), [&](const Record &other) {
        return other.name == name;
      });
    if (record != records.end())
      return record - records.begin();
    records.emplace_back();
    records.back().name = name;
    return records.size() - 1;
  }



  Timings::Scope::Scope(Timings &timings, const unsigned int section)
    : timings(timings)
    , section(section)
    , begin(std::chrono::steady_clock::now())
  {}



  Timings::Scope::~Scope()
  {
    auto &record = timings.records[section];
    record.seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
    ++record.n_calls;
  }



  double
  Timings::seconds(const unsigned int section) const
  {
    return records[section].seconds;
  }



  std::string
  Timings::table(const double total) const
  {
    std::ostringstream out;
    const auto         row = [&](const std::string &name,
                         const std::string &calls,
                         const double       seconds) {
      out << "  " << std::left << std::setw(28) << name << std::right
          << std::setw(12) << calls << std::setw(14) << duration_text(seconds)
          << std::setw(8) << std::fixed << std::setprecision(1)
          << (total > 0. ? 100. * seconds / total : 0.) << " %\n";
    };

    out << "  " << std::left << std::setw(28) << "Section" << std::right
        << std::setw(12) << "calls" << std::setw(14) << "wall time"
        << std::setw(10) << "share"
        << "\n";
    double covered = 0.;
    for (const auto &record : records)
      {
        row(record.name, count_text(record.n_calls), record.seconds);
        covered += record.seconds;
      }
    row("other", "", std::max(0., total - covered));
    return out.str();
  }
} // namespace mpm_granular::Output
