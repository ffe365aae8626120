#ifndef mpm_granular_transfer_moving_least_squares_h
#define mpm_granular_transfer_moving_least_squares_h

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/mls_functions.h>

#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Points and nodes see each other through shape functions by moving least
   * squares, which with their gradients are continuous where points cross
   * cells (T90 to T92). Masses, momenta, forces, velocities and gradients all
   * use them, so forces are the exact adjoint of gradients.
   *
   * What the points of a cell give to the nodes depends on where each of them
   * is, so it goes to the nodes directly (Grid::SpreadSums); the cells are
   * active but have no sums.
   */
  template <int dim>
  class MovingLeastSquares : public Averaging<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    suitable_filter_rate() const override
    {
      return 0.3;
    }

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) override;

    bool
    reaches_beyond_cells() const override
    {
      return true;
    }

    void
    add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                          const Points::PointArrays<dim>  &points,
                          const PointBlock<dim>           &block,
                          Grid::NodalFields<dim>          &fields) override;

    void
    add_stresses(const Points::PointArrays<dim> &points,
                 const PointBlock<dim>          &block,
                 Grid::NodalFields<dim>         &fields) override;

    void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             PointBlock<dim>                &block) const override;

    void
    move_points(const Mesh::BackgroundMesh<dim> &mesh,
                const Grid::NodalFields<dim>    &fields,
                PointBlock<dim>                 &block,
                const double                     time_step,
                const double                     pic_factor,
                Points::PointArrays<dim>        &points) const override;

  private:
    /**
     * The functions at the points of a block. They are needed several times
     * before the points move, and so dear that they are kept until then.
     */
    class BlockFunctions
    {
    public:
      void
      reinit(const Mesh::BackgroundMesh<dim> &mesh);

      /// Finds the functions, if they are not those of this block already.
      void
      find(const Points::PointArrays<dim> &points,
           const PointBlock<dim>          &block);

      /// Those of point @p p of the block; none if it has left the mesh.
      typename Grid::SpreadSums<dim>::Functions
      of_point(const unsigned int p) const
      {
        return dealii::make_array_view(functions.begin() + first[p - begin],
                                       functions.begin() +
                                         first[p - begin + 1]);
      }

    private:
      MlsFunctions<dim>                    at_places;
      unsigned int                         begin = 0; ///< of the block
      std::vector<unsigned int>            cells;
      std::vector<dealii::Point<dim>>      places;
      std::vector<unsigned int>            first; ///< of each point, and end
      std::vector<Grid::NodeFunction<dim>> functions;
    };

    mutable BlockFunctions functions;
  };
} // namespace mpm_granular::Transfer

#endif
