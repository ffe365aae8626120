#ifndef mpm_granular_transfer_position_shift_h
#define mpm_granular_transfer_position_shift_h

#include <mpm_granular/grid/velocity_constraints.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/transfer/filling.h>

#include <string>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Moves points from where there are too many of them to where there is room,
   * on meshes of simplices: down the gradient of what surroundings of nodes
   * hold beyond their volume (T69). Velocities and stresses stay, so mass and
   * momentum do; the centre of mass need not.
   */
  template <int dim>
  class PositionShift : public Parameters::ParameterGroup
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    /// Rate [1/s].
    /// @param automatic what suits the body and the averages.
    double
    rate(const double automatic) const;

    /**
     * Adds the shift to NodeMotion::velocity, with which points move, except
     * for prescribed components. Collective.
     *
     * @param rate [1/s].
     * @param filling of this step.
     * @param cell_sizes by flat cell [m].
     * @param constraints walls that only push hold here, too.
     * @param time_step [s].
     * @return mass times mean velocity of the shift: this rank's part of a sum
     *   over the ranks [kg m/s].
     */
    dealii::Tensor<1, dim>
    add(const Mesh::BackgroundMesh<dim>      &mesh,
        const Mesh::Partition<dim>           &partition,
        const double                          rate,
        const Filling<dim>                   &filling,
        const std::vector<double>            &cell_sizes,
        const Grid::VelocityConstraints<dim> &constraints,
        const double                          time_step,
        Grid::NodalFields<dim>               &fields) const;

  private:
    std::string given_rate = "automatic"; ///< [1/s]
  };
} // namespace mpm_granular::Transfer

#endif
