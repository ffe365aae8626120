#ifndef mpm_granular_transfer_node_averaging_h
#define mpm_granular_transfer_node_averaging_h

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/filling.h>
#include <mpm_granular/transfer/stress_power.h>

#include <array>
#include <cstdint>
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
    activate_enclosed(Grid::NodalFields<dim> &fields);

    /// Sums the points' stresses to the nodes.
    void
    sum_stresses(Grid::NodalFields<dim> &fields);

    bool   makes_room    = false; ///< whether points should be shifted
    double averaged_part = 0.9; ///< beta, the rest is taken from the cell alone

    const Mesh::BackgroundMesh<dim> *mesh      = nullptr;
    const Mesh::Partition<dim>      *partition = nullptr;
    Filling<dim>                     filling;

    struct CellOfNode
    {
      unsigned int                            index;
      std::array<unsigned int, Cell::n_nodes> node;
    };

    /// Each cell at its node with the lowest number: cells of node i are
    /// [first_cell[i], first_cell[i + 1]).
    std::vector<unsigned int> first_cell;
    std::vector<CellOfNode>   cells_of_node;

    /// By node and cell of the mesh, for activate_enclosed(), which leaves them
    /// as they were: all false, all true.
    std::vector<std::uint8_t> is_known;
    std::vector<std::uint8_t> is_empty;

    /// Stress components in the order of n_stress; lanes behind them are zero.
    using StressLanes =
      std::array<Lanes, (n_stress<dim> + Lanes::n - 1) / Lanes::n>;

    static constexpr unsigned int n_nodes = Cell::n_nodes;

    /// sum_p V_p sigma_p N_k by vertex.
    using StressParts = std::array<StressLanes, n_nodes>;
    static constexpr unsigned int n_parts =
      sizeof(StressParts) / sizeof(double);

    /// Those that other ranks have points in count, too. In the slots behind
    /// them are enclosed cells without points.
    unsigned int n_cells_with_points = 0;

    // By slot of the cell, if it has points.
    std::vector<StressParts> parts;
    std::vector<StressLanes> own_stresses; ///< sum_p V_p sigma_p

    // By slot of the cell.
    std::vector<double>                cell_weights; ///< Omega_e; 0 if not own
    std::vector<double>                own_factors;  ///< c_e
    std::vector<VelocityGradient<dim>> cell_gradients; ///< L_e of own cells

    // By slot of the node.
    std::vector<double>      node_weights;   ///< Omega_k
    std::vector<double>      stress_factors; ///< c_k / Omega_k
    std::vector<StressLanes> stresses; ///< with the factor, hanging nodes too
    std::vector<VelocityGradient<dim>> gradients; ///< L_k, hanging nodes too
  };
} // namespace mpm_granular::Transfer

#endif
