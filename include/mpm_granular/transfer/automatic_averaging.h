#ifndef mpm_granular_transfer_automatic_averaging_h
#define mpm_granular_transfer_automatic_averaging_h

#include <mpm_granular/transfer/averaging.h>

#include <memory>

namespace mpm_granular::Transfer
{
  /**
   * What suits the body at the start, for the whole run: for grains means in
   * cells, or means around nodes if simplices have few points; nothing for
   * elastic bodies alone, into which means in cells can feed energy. Hands
   * everything on to these.
   */
  template <int dim>
  class AutomaticAveraging : public Averaging<dim>
  {
  public:
    AutomaticAveraging();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    suit(const BodyTraits &body) override;

    std::string
    name_in_use(const std::string &chosen_name) const override;

    double
    suitable_filter_rate() const override;

    double
    suitable_shift_rate() const override;

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) override;

    void
    clear() override;

    void
    clear_stresses() override;

    void
    add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                          const Points::PointArrays<dim>  &points,
                          const PointBlock<dim>           &block,
                          Grid::NodalFields<dim>          &fields) override;

    void
    add_volumes(const Points::PointArrays<dim> &points,
                const PointBlock<dim>          &block,
                const Grid::NodalFields<dim>   &fields) override;

    void
    add_stresses(const Points::PointArrays<dim> &points,
                 const PointBlock<dim>          &block,
                 Grid::NodalFields<dim>         &fields) override;

    void
    find_weights(Grid::NodalFields<dim> &fields) override;

    const Filling<dim> *
    filling_of_nodes() const override;

    bool
    sets_forces() const override;

    void
    find_forces(Grid::NodalFields<dim> &fields) override;

    void
    find_gradients(Grid::NodalFields<dim> &fields) override;

    void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             PointBlock<dim>                &block) const override;

    double
    lost_power(const Grid::NodalFields<dim> &fields) const override;

    void
    serialize(Core::Archive &archive) override;

  private:
    void
    use(const std::string &name);

    std::string                     name;
    std::unique_ptr<Averaging<dim>> averaging;
    bool                            is_of_simplices = false;
  };
} // namespace mpm_granular::Transfer

#endif
