#ifndef mpm_granular_drive_yield_line_h
#define mpm_granular_drive_yield_line_h

#include <mpm_granular/materials/constitutive_law.h>

#include <utility>
#include <vector>

namespace mpm_granular::Drive
{
  /**
   * Where a law begins to flow, found by trying: at each pressure, the q up to
   * which the stress stays as it is without strain.
   *
   * @param direction the deviators are multiples of it.
   * @param lowest,highest pressures [Pa].
   * @return pressures and q [Pa], without the pressures that the law does not
   *   bear or at which nothing flows up to a hundred times the highest one.
   */
  std::vector<std::pair<double, double>>
  yield_line(const Materials::ConstitutiveLaw<3> &law,
             const Stress<3>                     &direction,
             const double                         lowest,
             const double                         highest);
} // namespace mpm_granular::Drive

#endif
