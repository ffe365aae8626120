#ifndef mpm_granular_mesh_background_mesh_h
#define mpm_granular_mesh_background_mesh_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>

#include <mpm_granular/mesh/mesh_source.h>
#include <mpm_granular/mesh/simplex_cell.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace mpm_granular::Mesh
{
  /// A boundary face as conditions need it.
  template <int dim>
  struct BoundaryFace
  {
    dealii::types::boundary_id    boundary;
    unsigned int                  cell;
    std::array<unsigned int, dim> node;   ///< DoF indices
    dealii::Tensor<1, dim>        normal; ///< unit, outward
    double                        area;   ///< [m^2], in 2D [m]
  };

  /**
   * The background mesh: deal.II's triangulation of simplices with its linear
   * space, and a flat copy of what the time step reads of each cell.
   *
   * Cells and nodes are numbered along a space-filling curve, so that what is
   * near in space is near in memory. "Cell" as an unsigned int always means
   * this flat index.
   */
  template <int dim>
  class BackgroundMesh
  {
  public:
    using CellIterator =
      typename dealii::Triangulation<dim>::active_cell_iterator;

    /**
     * Makes and checks the mesh.
     *
     * @param input_file the parameter file that names of mesh files are
     *   relative to.
     * @throws InputError if @p source cannot be read or the mesh is not valid
     *   (inverted cells, gaps).
     */
    BackgroundMesh(const MeshSource<dim> &source,
                   const std::string     &input_file);

    const dealii::Triangulation<dim> &
    triangulation() const
    {
      return tria;
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
      return map;
    }

    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    unsigned int
    n_nodes() const
    {
      return node_positions.size();
    }

    const SimplexCell<dim> &
    cell(const unsigned int index) const
    {
      return cells[index];
    }

    /// The cell of the triangulation that flat cell @p index stands for.
    const CellIterator &
    cell_iterator(const unsigned int index) const
    {
      return iterators[index];
    }

    /// The flat index of a cell of the triangulation.
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

    /// Smallest distance of a vertex to the opposite face [m].
    double
    altitude(const unsigned int index) const;

    const dealii::Point<dim> &
    node_position(const unsigned int node) const
    {
      return node_positions[node];
    }

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

    /// The cell that holds @p x (on its surface up to round-off counts), or
    /// no_cell. For setting up; the time step walks.
    unsigned int
    locate(const dealii::Point<dim> &x) const;

    /// The box around the whole mesh.
    const dealii::BoundingBox<dim> &
    bounding_box() const
    {
      return box;
    }

    /// The d-th root of the mean cell volume times d!: the edge of the mean
    /// cell's box [m].
    double
    mean_cell_size() const;

    /// Memory of triangulation, space and flat copy [bytes].
    std::size_t
    memory_consumption() const;

  private:
    void
    number_along_curve();
    void
    fill_cells();
    void
    fill_faces();
    void
    check() const;

    dealii::Triangulation<dim>      tria;
    dealii::FE_SimplexP<dim>        fe;
    dealii::MappingFE<dim>          map;
    dealii::DoFHandler<dim>         dofs;
    MeshNames                       names;
    std::vector<SimplexCell<dim>>   cells;
    std::vector<double>             volumes;
    std::vector<CellIterator>       iterators;
    std::vector<unsigned int>       flat_indices;
    std::vector<dealii::Point<dim>> node_positions;
    std::vector<BoundaryFace<dim>>  faces;
    dealii::BoundingBox<dim>        box;

    struct Locator;
    mutable std::shared_ptr<Locator> locator;
  };

  /// A place as "(x, y, z) m", for messages.
  template <int dim>
  std::string
  as_text(const dealii::Point<dim> &x);
} // namespace mpm_granular::Mesh

#endif
