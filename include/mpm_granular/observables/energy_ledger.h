#ifndef mpm_granular_observables_energy_ledger_h
#define mpm_granular_observables_energy_ledger_h

#include <deal.II/base/mpi.h>

namespace mpm_granular::Observables
{
  /**
   * The energies that have left or entered the points since the start, summed
   * step by step where they arise (T28) [J, in 2D J/m].
   */
  struct EnergyLedger
  {
    double dissipated    = 0; ///< taken by the laws
    double boundary_work = 0; ///< done on the body by constraints and tractions
    double transfer_loss = 0; ///< lost between points and grid, and in merging
    double filter_loss   = 0; ///< taken by the pressure filter
    double damping       = 0; ///< taken by damping

    /// The sum over the ranks.
    EnergyLedger
    summed(const MPI_Comm communicator) const
    {
      EnergyLedger total = *this;
      for (double *const part : {&total.dissipated,
                                 &total.boundary_work,
                                 &total.transfer_loss,
                                 &total.filter_loss,
                                 &total.damping})
        *part = dealii::Utilities::MPI::sum(*part, communicator);
      return total;
    }
  };
} // namespace mpm_granular::Observables

#endif
