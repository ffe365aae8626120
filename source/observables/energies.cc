#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/energies.h>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  double
  elastic_energy(
    const Points::PointArrays<dim>                             &points,
    const std::vector<const Materials::ConstitutiveLaw<dim> *> &laws)
  {
    double      energy = 0.;
    Stress<dim> stress;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          stress[c] = points.stress[c][i];
        energy += points.volume[i] *
                  laws[points.material[i]]->elastic_energy_density(stress);
      }
    return energy;
  }



  template <int dim>
  StoredEnergy
  stored_energy(const Snapshot<dim> &snapshot, const Frame<dim> &frame)
  {
    const auto  &points  = snapshot.points;
    const double gravity = snapshot.gravity.norm();
    StoredEnergy energy;
    energy.elastic = elastic_energy(points, snapshot.laws);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        double square_speed = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          square_speed += points.velocity[d][i] * points.velocity[d][i];
        energy.kinetic +=
          0.5 * snapshot.mass_scaling * points.mass[i] * square_speed;
        energy.potential +=
          points.mass[i] * gravity * frame.height(points.location(i));
      }
    for (double *const part :
         {&energy.kinetic, &energy.elastic, &energy.potential})
      *part = Utilities::MPI::sum(*part, snapshot.communicator);
    return energy;
  }



  template <int dim>
  std::vector<std::string>
  Energies<dim>::columns() const
  {
    return {"kinetic_energy",
            "elastic_energy",
            "potential_energy",
            "dissipated_energy",
            "boundary_work",
            "transfer_loss",
            "filter_loss",
            "damping",
            "closure"};
  }



  template <int dim>
  std::vector<double>
  Energies<dim>::values(const Snapshot<dim> &snapshot, const Frame<dim> &frame)
  {
    const StoredEnergy now    = stored_energy(snapshot, frame);
    const EnergyLedger ledger = snapshot.ledger.summed(snapshot.communicator);
    if (!initial || (initial_time < 0. && snapshot.time >= 0.))
      {
        initial      = now;
        initial_time = snapshot.time;
      }

    const double error = now.total() + ledger.dissipated +
                         ledger.transfer_loss + ledger.filter_loss +
                         ledger.damping - ledger.boundary_work -
                         initial->total();
    const double scale =
      initial->potential > 0. ? initial->potential : initial->total();
    return {now.kinetic,
            now.elastic,
            now.potential,
            ledger.dissipated,
            ledger.boundary_work,
            ledger.transfer_loss,
            ledger.filter_loss,
            ledger.damping,
            scale > 0. ? error / scale : error};
  }



  template <int dim>
  void
  Energies<dim>::serialize(Core::Archive &archive)
  {
    std::vector<double> energies;
    if (initial)
      energies = {initial->kinetic,
                  initial->elastic,
                  initial->potential,
                  initial_time};
    archive.replicated("observables/initial_energies", energies);
    if (archive.is_reading() && energies.size() == 4)
      {
        initial      = StoredEnergy{energies[0], energies[1], energies[2]};
        initial_time = energies[3];
      }
  }



  namespace
  {
    const RegisterObservable<Energies>
      entry("energies", "Energies of the points and what they gave and took.");
  }

  template double
  elastic_energy(const Points::PointArrays<2> &,
                 const std::vector<const Materials::ConstitutiveLaw<2> *> &);
  template double
  elastic_energy(const Points::PointArrays<3> &,
                 const std::vector<const Materials::ConstitutiveLaw<3> *> &);

  template StoredEnergy
  stored_energy(const Snapshot<2> &, const Frame<2> &);
  template StoredEnergy
  stored_energy(const Snapshot<3> &, const Frame<3> &);

  template class Energies<2>;
  template class Energies<3>;
} // namespace mpm_granular::Observables
