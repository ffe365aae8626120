#ifndef mpm_granular_observables_observable_h
#define mpm_granular_observables_observable_h

#include <mpm_granular/core/archive.h>
#include <mpm_granular/core/registry.h>
#include <mpm_granular/observables/frame.h>
#include <mpm_granular/observables/snapshot.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>
#include <vector>

namespace mpm_granular::Observables
{
  /**
   * One or several numbers that describe the state of the whole body: columns
   * of observables.csv. All registered observables are written; a new one needs
   * its own two files only.
   */
  template <int dim>
  class Observable : public Parameters::ParameterGroup
  {
  public:
    void
    add_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /// Names of the columns, without unit, separator or quotes.
    virtual std::vector<std::string>
    columns() const = 0;

    /**
     * The values of the columns now, in SI units.
     *
     * Not const: an observable may remember what it has seen, say the first
     * state.
     *
     * @param snapshot the state.
     * @param frame where along and up are.
     */
    virtual std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) = 0;

    /// What the observable remembers, for checkpoints; names begin with
    /// "observables/" and its own.
    virtual void
    serialize(Core::Archive & /*archive*/)
    {}
  };

  template <int dim>
  using ObservableRegistry = Core::Registry<Observable<dim>>;

  /// A static object of this type registers an observable for both dimensions.
  template <template <int> class Implementation>
  struct RegisterObservable
  {
    RegisterObservable(const std::string &name,
                       const std::string &documentation)
      : plane(name, documentation)
      , space(name, documentation)
    {}

    typename ObservableRegistry<2>::template Entry<Implementation<2>> plane;
    typename ObservableRegistry<3>::template Entry<Implementation<3>> space;
  };
} // namespace mpm_granular::Observables

#endif
