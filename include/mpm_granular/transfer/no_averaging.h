#ifndef mpm_granular_transfer_no_averaging_h
#define mpm_granular_transfer_no_averaging_h

#include <mpm_granular/transfer/averaging.h>

namespace mpm_granular::Transfer
{
  /// Each point acts on the nodes of its cell with its own stress and volume,
  /// and strains with the gradient at its place: the method of the paper.
  template <int dim>
  class NoAveraging : public Averaging<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    suitable_filter_rate() const override
    {
      return 0.;
    }

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) override;

    void
    add_stresses(const Points::PointArrays<dim> &points,
                 const PointBlock<dim>          &block,
                 Grid::NodalFields<dim>         &fields) override;

    void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             PointBlock<dim>                &block) const override;

  private:
    const Mesh::BackgroundMesh<dim> *mesh = nullptr;
  };
} // namespace mpm_granular::Transfer

#endif
