#ifndef mpm_granular_transfer_node_averaging_h
#define mpm_granular_transfer_node_averaging_h

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/filling.h>
#include <mpm_granular/transfer/stress_power.h>

#include <array>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Velocity gradients are means over the cells around each node, interpolated
   * to the points, and forces are what does the same work: the stresses of the
   * points go to the nodes and from there to the cells around (T42, T43). Both
   * are continuous where points cross cells. All cells whose nodes have points
   * around them take part, also those without points of their own.
   *
   * In the manner of the dual domain method of Zhang, Ma and Giguere (2011).
   */
  template <int dim>
  class NodeAveraging : public Averaging<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    suit(const BodyTraits &body) override;

    double
    suitable_filter_rate() const override
    {
      return 0.2;
    }

    double
    suitable_shift_rate() const override
    {
      return makes_room ? 10. : 0.;
    }

    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) override;

    void
    clear() override;

    void
    clear_stresses() override;

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
    filling_of_nodes() const override
    {
      return &filling;
    }

    bool
    sets_forces() const override
    {
      return true;
    }

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
    using Cell = Mesh::SimplexCell<dim>;

    /// Makes the cells active whose nodes all are.
    void
    activate_enclosed(Grid::NodalFields<dim> &fields) const;

    /// Sums the points' stresses to the nodes.
    void
    sum_stresses(Grid::NodalFields<dim> &fields);

    bool   makes_room    = false; ///< whether points should be shifted
    double averaged_part = 0.9; ///< beta, the rest is taken from the cell alone

    const Mesh::BackgroundMesh<dim> *mesh      = nullptr;
    const Mesh::Partition<dim>      *partition = nullptr;
    Filling<dim>                     filling;

    /// Each cell at its node with the lowest number: cells of node i are
    /// [first_cell[i], first_cell[i + 1]).
    std::vector<unsigned int> first_cell;
    std::vector<unsigned int> cells_of_node;

    static constexpr unsigned int n_nodes = Cell::n_nodes;
    static constexpr unsigned int n_parts = n_stress<dim> * n_nodes;

    /// sum_p V_p sigma_p N_k by cell slot, then component, then vertex.
    std::vector<double>      parts;
    std::vector<double>      cell_weights;   ///< Omega_e by slot; 0 if not own
    std::vector<double>      node_weights;   ///< Omega_k by slot
    std::vector<Stress<dim>> stresses;       ///< of nodes, over Omega_k
    std::vector<double>      stress_factors; ///< c_k / Omega_k by slot
    std::vector<VelocityGradient<dim>> gradients; ///< of nodes
  };
} // namespace mpm_granular::Transfer

#endif
