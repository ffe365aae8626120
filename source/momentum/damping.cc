#include <mpm_granular/momentum/damping.h>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  void
  Damping<dim>::compute(const double                          time_step,
                        const Grid::VelocityConstraints<dim> &constraints,
                        NodalVectors<dim>                     momentum,
                        NodalVectors<dim>                     impulse,
                        NodalVectors<dim>                    &result) const
  {
    constraints.project(momentum);
    constraints.project(impulse);
    result.assign(momentum.size(), Tensor<1, dim>());
    add(time_step, momentum, impulse, result);
    constraints.project(result);
  }

  template class Damping<2>;
  template class Damping<3>;

  namespace
  {
    template <int dim>
    class NoDamping : public Damping<dim>
    {
    public:
      void
      add_parameters(ParameterHandler &) override
      {}

      bool
      is_active() const override
      {
        return false;
      }

    private:
      void
      add(const double,
          const NodalVectors<dim> &,
          const NodalVectors<dim> &,
          NodalVectors<dim> &) const override
      {}
    };

    const std::string                             documentation = "nothing.";
    const DampingRegistry<2>::Entry<NoDamping<2>> none_2d("none",
                                                          documentation);
    const DampingRegistry<3>::Entry<NoDamping<3>> none_3d("none",
                                                          documentation);
  } // namespace
} // namespace mpm_granular::Momentum
