#ifndef mpm_granular_transfer_mls_functions_h
#define mpm_granular_transfer_mls_functions_h

#include <mpm_granular/grid/spread_sums.h>
#include <mpm_granular/mesh/background_mesh.h>

#include <array>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Shape functions of a mesh of simplices by moving least squares (T90 to
   * T92): at each place a linear field is fitted to the values of the nodes
   * around; the functions are its value and its gradient. A node's weight in
   * the fit is a kernel of its distance times a factor that vanishes where the
   * place leaves the cells next to the node's, so that both are continuous
   * where a point crosses into another cell.
   *
   * The functions add up to one, reproduce linear fields and are not negative.
   * On the surface of the mesh those of inner nodes therefore vanish, and walls
   * hold points as they do with linear functions; gradients may jump in the
   * cells there.
   *
   * After Cao et al., Unstructured moving least squares material point methods
   * (arXiv:2312.10338), with a kernel of our own and without negative values.
   */
  template <int dim>
  class MlsFunctions
  {
  public:
    /// Prepares for a mesh of simplices without hanging nodes, which must live
    /// as long.
    void
    reinit(const Mesh::BackgroundMesh<dim> &mesh);

    /**
     * Appends the functions at a place to a list: first those of the cell's
     * own nodes, which are positive, then others that do not vanish.
     *
     * @param cell the one that holds @p x. Quick if it is the one of the call
     *   before.
     */
    void
    evaluate(const unsigned int                    cell,
             const dealii::Point<dim>             &x,
             std::vector<Grid::NodeFunction<dim>> &functions);

  private:
    using Cell = Mesh::SimplexCell<dim>;

    void
    add_candidate(const unsigned int node);
    void
    find_candidates(const unsigned int cell);
    void
    find_samples(const dealii::Point<dim>                       &x,
                 const std::array<double, std::size_t(dim + 1)> &shape_values);
    /// Fits the samples, of which those with negative functions are left out.
    /// @return whether they determine a linear field.
    bool
    fit();

    const Mesh::BackgroundMesh<dim> *mesh = nullptr;

    /// Nodes that have a cell in common with node i, [first_neighbor[i],
    /// first_neighbor[i + 1]) of neighbors, ascending; without i.
    std::vector<unsigned int> first_neighbor;
    std::vector<unsigned int> neighbors;
    std::vector<double>       radii; ///< of the kernels, by node [m]

    /// A node that may see points of a cell.
    struct Candidate
    {
      unsigned int       node;
      dealii::Point<dim> position;
      double             inverse_square; ///< of its kernel's radius [1/m^2]

      /// Whether it is next to vertex k of the cell: 1 or 0.
      std::array<double, Cell::n_nodes> is_next_to;
    };

    /// A node that sees the point.
    struct Sample
    {
      unsigned int           candidate;
      double                 weight;
      dealii::Tensor<1, dim> offset; ///< from the point [m]
      double                 value;  ///< of its function
      dealii::Tensor<1, dim> gradient;
    };

    unsigned int              cell_of_candidates = Mesh::no_cell;
    std::vector<Candidate>    candidates;    ///< the cell's own nodes first
    std::vector<unsigned int> place_of_node; ///< among the candidates
    std::vector<Sample>       samples;
  };
} // namespace mpm_granular::Transfer

#endif
