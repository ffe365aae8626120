#ifndef tests_checkpoint_state_h
#define tests_checkpoint_state_h

#include <mpm_granular/checkpoint/checkpoint_file.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace Test
{
  using namespace mpm_granular;
  namespace Mpi = dealii::Utilities::MPI;

  /// Something of every kind that an archive keeps.
  struct State
  {
    double                    time     = 0.;
    unsigned int              step     = 0;
    std::uint64_t             n_points = 0;
    bool                      flag     = false;
    std::string               text;
    std::string               no_text = "old";
    std::vector<double>       numbers;
    std::vector<double>       no_numbers = {1.};
    std::vector<double>       position;
    std::vector<unsigned int> cell;
    std::vector<std::uint8_t> material;
    std::vector<double>       sums;    ///< three a row, of another group
    std::vector<double>       nothing; ///< no row on any process

    void
    serialize(Core::Archive &archive)
    {
      archive.replicated("state/time", time);
      archive.replicated("state/step", step);
      archive.replicated("state/n_points", n_points);
      archive.replicated("state/flag", flag);
      archive.replicated("state/text", text);
      archive.replicated("state/no_text", no_text);
      archive.replicated("state/numbers", numbers);
      archive.replicated("state/no_numbers", no_numbers);
      archive.distributed("points/position", position);
      archive.distributed("points/cell", cell);
      archive.distributed("points/material", material);
      archive.distributed("grid/sums", sums, 3);
      archive.distributed("empty/nothing", nothing);
    }

    /// Whether all is the same, bit for bit.
    bool
    operator==(const State &other) const
    {
      const auto same = [](const auto &first, const auto &second) {
        return first.size() == second.size() &&
               (first.empty() ||
                std::memcmp(first.data(),
                            second.data(),
                            first.size() * sizeof(first[0])) == 0);
      };
      return time == other.time &&
             std::signbit(time) == std::signbit(other.time) &&
             step == other.step && n_points == other.n_points &&
             flag == other.flag && text == other.text &&
             no_text == other.no_text && same(numbers, other.numbers) &&
             same(no_numbers, other.no_numbers) &&
             same(position, other.position) && same(cell, other.cell) &&
             same(material, other.material) && same(sums, other.sums) &&
             same(nothing, other.nothing);
    }
  };

  constexpr unsigned int n_rows = 37;

  /// The rows [begin, end) of a table of n_rows points.
  inline State
  make_state(const unsigned int begin, const unsigned int end)
  {
    State state;
    state.time     = -0.;
    state.step     = 4000000000u;
    state.n_points = 1ull << 60;
    state.flag     = true;
    state.text     = "two\nlines, \"quoted\"";
    state.no_text  = "";
    state.numbers  = {1. / 3.,
                      std::numeric_limits<double>::denorm_min(),
                      std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::quiet_NaN()};
    state.no_numbers.clear();
    for (unsigned int i = begin; i < end; ++i)
      {
        state.position.push_back(std::sin(i));
        state.cell.push_back(i * i);
        state.material.push_back(i % 3);
      }
    // Another number of rows, all of them with the last points.
    if (end == n_rows)
      for (unsigned int i = 0; i < 6; ++i)
        state.sums.push_back(std::cos(i));
    return state;
  }
} // namespace Test

#endif
