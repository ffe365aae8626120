#ifndef mpm_granular_mesh_background_mesh_h
#define mpm_granular_mesh_background_mesh_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <boost/container/static_vector.hpp>

#include <mpm_granular/mesh/box_cell.h>
#include <mpm_granular/mesh/mesh_source.h>
#include <mpm_granular/mesh/refinement.h>
#include <mpm_granular/mesh/simplex_cell.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mpm_granular::Mesh
{
  /// Stands for "no cell": what lies beyond a boundary face.
  inline constexpr unsigned int no_cell = dealii::numbers::invalid_unsigned_int;

  /// Stands for a cell that this rank does not know.
  inline constexpr unsigned int unknown_cell = no_cell - 1;

  /// Stands for a node that this rank does not know.
  inline constexpr unsigned int unknown_node = no_cell;

  /// A boundary face as conditions need it.
  template <int dim>
  struct BoundaryFace
  {
    unsigned int cell; ///< or unknown_cell

    /// Its vertices, in deal.II's order; unknown_node where they are not here.
    boost::container::static_vector<unsigned int, 1 << (dim - 1)> node;

    dealii::types::boundary_id boundary;
    dealii::Tensor<1, dim>     normal; ///< unit, outward
    double                     area;   ///< [m^2], in 2D [m]
  };

  /**
   * The background mesh: deal.II's triangulation with its linear space, and a
   * flat copy of what the time step reads of each cell.
   *
   * Of a mesh of simplices every rank has all cells. A mesh of hypercubes is
   * *distributed* by p4est: a rank has its own cells and *ghost* cells, which
   * share a vertex with an own one.
   *
   * "Cell" as an unsigned int always means the flat index of a cell on this
   * rank. Cells are numbered along a space-filling curve and nodes as the cells
   * meet them, so that what is near in space is near in memory; own cells of a
   * distributed mesh come before ghosts. A *global* number is the same on all
   * ranks, and on any number of them.
   *
   * A mesh that is refined in places has *hanging* nodes; the others are free.
   * All functions of the linear space follow from their values at free nodes.
   */
  template <int dim>
  class BackgroundMesh
  {
  public:
    using CellIterator =
      typename dealii::Triangulation<dim>::active_cell_iterator;

    /**
     * Makes and checks the mesh. Collective.
     *
     * @param input_file the parameter file that names of mesh files are
     *   relative to.
     * @param communicator of the ranks that share a distributed mesh.
     * @throws InputError if @p source cannot be read or the mesh is not valid
     *   (inverted cells, gaps, hypercubes that are not box-like).
     */
    BackgroundMesh(const MeshSource<dim> &source,
                   const std::string     &input_file,
                   const MPI_Comm         communicator = MPI_COMM_WORLD);

    MPI_Comm
    mpi_communicator() const
    {
      return communicator;
    }

    CellKind
    cell_kind() const
    {
      return kind;
    }

    /// Whether each rank has a part of the mesh only.
    bool
    is_distributed() const
    {
      return kind == CellKind::hypercube;
    }

    /**
     * Shares the cells of a distributed mesh out anew. Flat indices change,
     * global ones do not. Collective.
     *
     * @param weights of the own cells.
     */
    void
    repartition(const std::vector<std::uint32_t> &weights);

    /**
     * Refines and coarsens cells, see Refinement::adapt(). Flat indices and
     * global numbers change. Collective.
     *
     * @param wanted_levels by flat cell.
     * @return nothing if the mesh is as it was; otherwise for each of the cells
     *   that this rank owned, one that lies in its place, or (if known here)
     *   near it.
     */
    std::optional<std::vector<unsigned int>>
    adapt(const std::vector<std::uint8_t> &wanted_levels);

    /// How often a cell is refined, counted from the mesh as given.
    unsigned int
    level(const unsigned int cell) const
    {
      return refinement->level(iterators[cell]);
    }

    /// All that is refined, see Refinement::tree(); for checkpoints.
    /// Collective.
    std::vector<std::uint8_t>
    refinement_tree() const;

    /// Makes the mesh with this refinement_tree() from the one given.
    /// Collective.
    void
    set_refinement_tree(const std::vector<std::uint8_t> &tree);

    const dealii::Triangulation<dim> &
    triangulation() const
    {
      return *tria;
    }

    /// The scalar linear space on the mesh; its DoFs are the nodes.
    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dofs;
    }

    const dealii::Mapping<dim> &
    mapping() const
    {
      return *map;
    }

    /// What the cells are like, as deal.II sees it.
    dealii::ReferenceCell
    reference_cell() const;

    /// Cells that this rank has.
    unsigned int
    n_cells() const
    {
      return iterators.size();
    }

    /// Of a distributed mesh, the cells that this rank owns, which come first;
    /// otherwise all.
    unsigned int
    n_own_cells() const
    {
      return n_own;
    }

    /// Nodes that this rank has.
    unsigned int
    n_nodes() const
    {
      return node_positions.size();
    }

    /// Cells on all ranks.
    std::uint64_t
    n_global_cells() const
    {
      return first_of_rank.back();
    }

    /// Nodes on all ranks.
    std::uint64_t
    n_global_nodes() const
    {
      return dofs.n_dofs();
    }

    unsigned int
    global_cell(const unsigned int cell) const
    {
      return cell < n_own ? first_own + cell : ghosts[cell - n_own];
    }

    /// The flat index of a cell, or unknown_cell.
    unsigned int
    local_cell(const unsigned int global_cell) const;

    /// The rank that owns a cell of a distributed mesh.
    unsigned int
    owner(const unsigned int global_cell) const;

    dealii::types::global_dof_index
    global_node(const unsigned int node) const
    {
      return global_nodes[node];
    }

    /// Calls @p action with the cells: a std::vector of SimplexCell or BoxCell.
    template <class Action>
    decltype(auto)
    visit(Action &&action) const
    {
      return std::visit(std::forward<Action>(action), all_cells);
    }

    /// The cells, if they are of the kind @p Cell.
    template <class Cell>
    const std::vector<Cell> &
    cells() const
    {
      return std::get<std::vector<Cell>>(all_cells);
    }

    dealii::ArrayView<const unsigned int>
    nodes(const unsigned int cell) const
    {
      return visit([&](const auto &cells) {
        return dealii::ArrayView<const unsigned int>(cells[cell].node.data(),
                                                     cells[cell].node.size());
      });
    }

    /// What the values at hanging nodes are, by node (T60).
    const dealii::AffineConstraints<double> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Whether a cell has vertices that are hanging nodes.
    bool
    has_hanging_vertex(const unsigned int cell) const
    {
      return !at_hanging.empty() && at_hanging[cell];
    }

    /// The free nodes that the linear space on a cell depends on.
    std::vector<unsigned int>
    free_nodes(const unsigned int cell) const;

    /// Sets values at hanging nodes from those at free ones.
    /// @param values @p n_values numbers per node.
    void
    interpolate_to_hanging_nodes(std::vector<double> &values,
                                 const unsigned int   n_values) const;

    /// The cells behind the faces of a cell, no_cell or unknown_cell; where
    /// there are several, one of them.
    dealii::ArrayView<const unsigned int>
    neighbors(const unsigned int cell) const
    {
      return visit([&](const auto &cells) {
        return dealii::ArrayView<const unsigned int>(
          cells[cell].neighbor.data(), cells[cell].neighbor.size());
      });
    }

    /// Where a place in a cell is in deal.II's reference cell.
    dealii::Point<dim>
    reference_point(const unsigned int cell, const dealii::Point<dim> &x) const
    {
      return visit(
        [&](const auto &cells) { return cells[cell].reference_point(x); });
    }

    /// The cell of the triangulation that flat cell @p index stands for.
    const CellIterator &
    cell_iterator(const unsigned int index) const
    {
      return iterators[index];
    }

    /// The flat index of a cell of the triangulation, or unknown_cell.
    unsigned int
    flat_index(const CellIterator &cell) const
    {
      return flat_indices[cell->active_cell_index()];
    }

    double
    cell_volume(const unsigned int index) const ///< [m^3], in 2D [m^2]
    {
      return volumes[index];
    }

    /// Smallest height of a cell above one of its faces [m].
    double
    altitude(const unsigned int index) const;

    const dealii::Point<dim> &
    node_position(const unsigned int node) const
    {
      return node_positions[node];
    }

    /// A free node's part of the volumes of the cells around it (T60) [m^3], in
    /// 2D [m^2].
    double
    node_volume(const unsigned int node) const
    {
      return node_volumes[node];
    }

    /// All faces that have a vertex on this rank.
    const std::vector<BoundaryFace<dim>> &
    boundary_faces() const
    {
      return faces;
    }

    /// Ids of boundaries by name: the file's physical names, for a box x_min,
    /// x_max, ...; a number as a string always works.
    const std::map<std::string, unsigned int> &
    boundary_names() const
    {
      return names.boundaries;
    }

    /// Material ids of sets of cells by name.
    const std::map<std::string, unsigned int> &
    region_names() const
    {
      return names.regions;
    }

    /**
     * The cells that hold some places (on a surface up to round-off counts).
     * For setting up; the time step walks. Collective; all ranks give the same
     * places.
     *
     * @return the cell of each place: no_cell if no rank has it, unknown_cell
     *   if it is not an own cell of this rank.
     */
    std::vector<unsigned int>
    locate(const std::vector<dealii::Point<dim>> &places) const;

    /// The box around the whole mesh.
    const dealii::BoundingBox<dim> &
    bounding_box() const
    {
      return box;
    }

    /// The lowest and highest coordinates of the mesh along a direction [m].
    /// Collective.
    std::pair<double, double>
    extent(const dealii::Tensor<1, dim> &direction) const;

    /// The edge of the box of which cells of a volume [m^3], in 2D [m^2], are
    /// parts: d! simplices make a box [m].
    double
    size_of_cell(const double volume) const
    {
      const double part_of_box = visit([](const auto &cells) {
        return std::decay_t<decltype(cells)>::value_type::reference_volume;
      });
      return dim == 2 ? std::sqrt(volume / part_of_box) :
                        std::cbrt(volume / part_of_box);
    }

    /// The size of a cell of mean volume; of the finest cells, if some are
    /// refined [m].
    double
    mean_cell_size() const
    {
      return mean_size;
    }

    /**
     * Hands what the owner of a cell of a distributed mesh knows of it to the
     * ranks that have it as a ghost. Collective.
     *
     * @param pack what is known of an own cell.
     * @param unpack takes what is known of a ghost cell.
     */
    template <class Data>
    void
    send_to_ghosts(const std::function<Data(const unsigned int cell)> &pack,
                   const std::function<void(const unsigned int cell,
                                            const Data &)> &unpack) const;

    /// Memory of triangulation, space and flat copy [bytes].
    std::size_t
    memory_consumption() const;

  private:
    void
    fill();
    void
    order_cells();
    void
    number_cells_globally();
    void
    number_nodes();
    template <class Cell>
    void
    fill_cells(std::vector<Cell> &cells);
    template <class Cell>
    void
    fill_faces(std::vector<Cell> &cells);
    unsigned int
    neighbor_of(const CellIterator &cell, const unsigned int face) const;
    void
    complete_nodes();
    void
    find_node_volumes();
    std::vector<unsigned int>
    cells_now(const std::vector<dealii::CellId> &before) const;
    void
    measure();

    using Cells =
      std::variant<std::vector<SimplexCell<dim>>, std::vector<BoxCell<dim>>>;
    using Distributed = dealii::parallel::distributed::Triangulation<dim>;

    MPI_Comm                                    communicator;
    CellKind                                    kind;
    std::unique_ptr<dealii::Triangulation<dim>> tria;
    Distributed *p4est = nullptr; ///< the same, if distributed
    std::unique_ptr<Refinement<dim>>            refinement;
    std::unique_ptr<dealii::FiniteElement<dim>> fe;
    std::unique_ptr<dealii::Mapping<dim>>       map;
    dealii::DoFHandler<dim>                     dofs;
    MeshNames                                   names;

    Cells                     all_cells;
    unsigned int              n_own     = 0; ///< of the cells
    unsigned int              first_own = 0; ///< its global number
    std::vector<unsigned int> ghosts;        ///< global numbers, ascending
    std::vector<unsigned int> first_of_rank; ///< global cell; the last: number
    std::vector<double>       volumes;
    std::vector<CellIterator> iterators;
    std::vector<unsigned int> flat_indices;
    std::vector<dealii::types::global_dof_index> global_nodes;
    std::vector<dealii::Point<dim>>              node_positions;
    std::vector<double>                          node_volumes;
    std::vector<BoundaryFace<dim>>               faces;
    dealii::AffineConstraints<double>            hanging; ///< by node
    /// By cell; empty if there are no hanging nodes.
    std::vector<bool>        at_hanging;
    dealii::BoundingBox<dim> box;
    double                   mean_size = 0.;
  };

  /// A place as "(x, y, z) m", for messages.
  template <int dim>
  std::string
  as_text(const dealii::Point<dim> &x);
} // namespace mpm_granular::Mesh

#endif
