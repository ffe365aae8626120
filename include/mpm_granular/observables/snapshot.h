#ifndef mpm_granular_observables_snapshot_h
#define mpm_granular_observables_snapshot_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/observables/energy_ledger.h>
#include <mpm_granular/points/point_arrays.h>

#include <cstddef>
#include <vector>

namespace mpm_granular::Observables
{
  /// All that an observable may look at, at one instant. Points, lost points
  /// and ledger are this rank's: what belongs to the whole body is the sum, the
  /// maximum or the like over all ranks.
  template <int dim>
  struct Snapshot
  {
    double       time;      ///< [s]
    unsigned int step;      ///< number of steps done
    double       time_step; ///< last dt [s]
    std::size_t  n_lost;    ///< points removed at the boundary so far

    dealii::Tensor<1, dim> gravity; ///< now [m/s^2]

    const Points::PointArrays<dim>  &points;
    const Mesh::BackgroundMesh<dim> &mesh;
    const std::vector<const Materials::ConstitutiveLaw<dim> *>
                       &laws; ///< by material
    const EnergyLedger &ledger;
    const MPI_Comm      communicator;
    double              mass_scaling = 1.; ///< of inertia
  };
} // namespace mpm_granular::Observables

#endif
