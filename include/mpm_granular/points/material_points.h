#ifndef mpm_granular_points_material_points_h
#define mpm_granular_points_material_points_h

#include <deal.II/particles/particle_handler.h>

#include <mpm_granular/core/archive.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/points/point_arrays.h>
#include <mpm_granular/points/point_layout.h>

#include <string>
#include <vector>

namespace mpm_granular::Points
{
  /**
   * The material points, in two forms of one truth.
   *
   * The working set (arrays()) is what the time step runs on. deal.II's
   * ParticleHandler (handler()) is how points are created and how they are
   * handed to anything of deal.II: it is filled by publish() and emptied by
   * load(), so that the memory of both is held at such moments only.
   */
  template <int dim>
  class MaterialPoints
  {
  public:
    /**
     * @param partition says which points this rank holds; must live as long.
     * @param history_names history slots of the laws, over all materials, and
     *   of the transfer.
     */
    MaterialPoints(const Mesh::BackgroundMesh<dim> &mesh,
                   const Mesh::Partition<dim>      &partition,
                   std::vector<std::string>         history_names);

    /// Creates points of a material in the handler, at rest and without stress:
    /// those in cells of this rank. Collective.
    /// @param density mass per initial volume [kg/m^3].
    void
    insert(const std::vector<Seed<dim>> &seeds,
           const unsigned int            material,
           const double                  density);

    /// Forgets all points.
    void
    clear();

    /// Moves all points from the handler to the working set.
    void
    load();

    /// Copies the working set to the handler.
    void
    publish();

    /// The working set.
    PointArrays<dim> &
    arrays()
    {
      return working_set;
    }

    const PointArrays<dim> &
    arrays() const
    {
      return working_set;
    }

    const std::vector<std::string> &
    history_names() const
    {
      return names;
    }

    /// deal.II's view of the points; empty unless published.
    const dealii::Particles::ParticleHandler<dim> &
    handler() const
    {
      return particles;
    }

    /// Names of the handler's properties, in their order.
    std::vector<std::string>
    property_names() const;

    /// Sorts the working set by host cell (stable, linear in the number of
    /// points).
    void
    order();

    /// Gives the cells of the points their global numbers, until attach() or
    /// send_home(): meanwhile points can go elsewhere, and the cells too.
    void
    release();

    /// Gives the cells of the points, which must be on this rank, their flat
    /// indices again.
    void
    attach();

    /// Sends points that are in cells of other ranks there, attaches and
    /// orders. Collective.
    /// @return how many this rank sent.
    std::size_t
    send_home();

    /// Moves points that round-off has brought beyond the boundary onto it:
    /// with smaller cells they would count as lost.
    void
    pull_inside();

    /// Finds the cells of all points in a mesh that has changed. They are all
    /// in cells of this rank, before and after.
    /// @param cells for each cell before, one in its place.
    void
    follow(const std::vector<unsigned int> &cells);

    /// The number of points in each cell, over all ranks; of a distributed mesh
    /// only those of this rank. Collective.
    /// @param weight how often each of the points of this rank counts.
    std::vector<std::uint32_t>
    count_by_cell(const std::uint32_t weight = 1) const;

    /// Divides points where a cell has some but fewer than a number
    /// (Points::split), gives the new ones ids, and orders. All points must be
    /// in own cells. Collective.
    /// @return how many points this rank has more.
    /// @throws ComputationError if there are no more ids.
    std::size_t
    split(const unsigned int least_per_cell);

    /// Removes the points whose cell is no_cell.
    /// @return how many there were.
    std::size_t
    remove_lost();

    /// The working set, for checkpoints.
    void
    serialize(Core::Archive &archive);

    /// Memory of both forms [bytes].
    std::size_t
    memory_consumption() const;

  private:
    const Mesh::BackgroundMesh<dim>        &mesh;
    const Mesh::Partition<dim>             &partition;
    std::vector<std::string>                names;
    PointArrays<dim>                        working_set;
    dealii::Particles::ParticleHandler<dim> particles;
    std::uint64_t                           n_ids = 0; ///< taken so far
    std::vector<unsigned int>               n_in_cell; ///< zero between calls
    std::vector<std::uint64_t> is_occupied; ///< bits of cells, zero as well
  };
} // namespace mpm_granular::Points

#endif
