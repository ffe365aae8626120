#ifndef mpm_granular_transfer_cell_averaging_h
#define mpm_granular_transfer_cell_averaging_h

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/filling.h>

namespace mpm_granular::Transfer
{
  /**
   * In filled surroundings the mean stress of a cell's points acts on the whole
   * volume of the cell, however many points it holds at the time (T41). A point
   * that crosses from one cell into another then changes their mean stresses
   * only, not the volumes they act on.
   */
  template <int dim>
  class CellAveraging : public Averaging<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    suitable_filter_rate() const override
    {
      return mesh->cell_kind() == Mesh::CellKind::simplex ? 0.8 : 0.5;
    }

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) override;

    void
    clear() override;

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

    bool
    sets_forces() const override
    {
      return true;
    }

    void
    find_forces(Grid::NodalFields<dim> &fields) override;

    void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             PointBlock<dim>                &block) const override;

    double
    lost_power(const Grid::NodalFields<dim> &fields) const override;

    void
    serialize(Core::Archive &archive) override;

  private:
    const Mesh::BackgroundMesh<dim> *mesh = nullptr;
    Filling<dim>                     filling;
    std::vector<double>              factors; ///< c_e by cell slot
  };
} // namespace mpm_granular::Transfer

#endif
