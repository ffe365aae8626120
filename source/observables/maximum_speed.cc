#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/maximum_speed.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  std::vector<std::string>
  MaximumSpeed<dim>::columns() const
  {
    return {"max_speed"};
  }



  template <int dim>
  std::vector<double>
  MaximumSpeed<dim>::values(const Snapshot<dim> &snapshot, const Frame<dim> &)
  {
    const auto &points         = snapshot.points;
    double      highest_square = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        double square = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          square += points.velocity[d][i] * points.velocity[d][i];
        highest_square = std::max(highest_square, square);
      }
    return {
      std::sqrt(Utilities::MPI::max(highest_square, snapshot.communicator))};
  }



  namespace
  {
    const RegisterObservable<MaximumSpeed> entry("maximum speed",
                                                 "The largest speed.");
  }

  template class MaximumSpeed<2>;
  template class MaximumSpeed<3>;
} // namespace mpm_granular::Observables
