#ifndef mpm_granular_observables_extent_h
#define mpm_granular_observables_extent_h

#include <mpm_granular/observables/mass_quantile.h>
#include <mpm_granular/observables/observable.h>

namespace mpm_granular::Observables
{
  /**
   * How far and how high the body reaches. The front is the coordinate along
   * the run-out below which 99.9 % of the mass lies; the height is the height
   * above the lowest point of the mesh below which 99.9 % of the mass lies, of
   * all points or of a column. Quantiles, because a few points always fly
   * ahead.
   */
  template <int dim>
  class Extent : public Observable<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    std::vector<std::string>
    columns() const override;

    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;

  private:
    /// Where the points are that the height is measured of.
    Slab<dim>
    column(const Snapshot<dim> &snapshot, const Frame<dim> &frame) const;

    double      mass_fraction   = 0.999;
    std::string height_of       = "all points";
    double      column_position = 0.; ///< [m]
    double      column_reach    = 0.; ///< [m]; 0: one mean cell size
  };
} // namespace mpm_granular::Observables

#endif
