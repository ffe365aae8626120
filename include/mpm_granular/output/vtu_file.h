#ifndef mpm_granular_output_vtu_file_h
#define mpm_granular_output_vtu_file_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <boost/container/static_vector.hpp>

#include <mpm_granular/core/archive.h>

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// A quantity to be written, as a function of the index of a node.
  struct Field
  {
    std::string  name;
    std::string  unit;
    unsigned int n_components; ///< 1, or dim for a vector

    /// The value of a component at a node.
    std::function<double(const std::size_t node, const unsigned int component)>
      value;
  };

  /// The nodes of a simplex or hypercube, in deal.II's order.
  template <int item_dim>
  using ItemNodes =
    boost::container::static_vector<std::size_t, (1u << item_dim)>;

  /**
   * What a VTU file shows: @p n_items simplices or hypercubes of dimension
   * @p item_dim (0 for points) with nodal fields. Nothing is copied; pieces are converted one
   * after the other.
   */
  template <int item_dim, int dim>
  struct VtuContents
  {
    std::size_t n_items;

    /// The nodes of an item.
    std::function<ItemNodes<item_dim>(const std::size_t)> nodes;

    /// The position of a node [m].
    std::function<dealii::Point<dim>(const std::size_t)> position;

    std::vector<Field> fields;
  };

  /**
   * Writes a VTU file with the functions of deal.II, in pieces of at most
   * 65,536 items, so that the memory this takes does not grow with the run.
   *
   * @param out where to; only the first rank's is used.
   * @param flags compression, time and the like.
   * @param contents what this rank adds.
   * @param communicator of the ranks whose contents make up the file;
   *   collective. The first rank asks them one by one for their pieces.
   */
  template <int item_dim, int dim>
  void
  write_vtu(std::ostream                        &out,
            const dealii::DataOutBase::VtkFlags &flags,
            const VtuContents<item_dim, dim>    &contents,
            const MPI_Comm                       communicator);

  /**
   * A series of VTU files over time, `NAME/NAME-00000.vtu` and so on, with the
   * record `NAME.pvd` that ParaView opens.
   */
  class VtuSeries
  {
  public:
    /**
     * @param folder the run's folder; it is looked at at the first write only.
     * @param name name of the series.
     * @param communicator of the ranks that call add(); the first one writes.
     */
    VtuSeries(const std::string &folder,
              const std::string &name,
              const MPI_Comm     communicator);

    /**
     * Writes the next file and the record, each atomically. Collective.
     *
     * @param time [s].
     * @param write writes the VTU file to the stream it is given; called on all
     *   ranks.
     * @throws ComputationError on all ranks if it cannot be written.
     */
    void
    add(const double time, const std::function<void(std::ostream &)> &write);

    unsigned int
    n_files() const
    {
      return times_and_names.size();
    }

    /// The instants of the files, for checkpoints.
    void
    serialize(Core::Archive &archive);

    /// Goes on in the folder of an interrupted run: removes the files after
    /// those that serialize() knows of, also from the record.
    void
    resume();

  private:
    /// The name of a file in the folder.
    std::string
    file_name(const unsigned int index) const;

    void
    write_record() const;

    std::string                                 folder;
    std::string                                 name;
    MPI_Comm                                    communicator;
    std::vector<std::pair<double, std::string>> times_and_names;
  };
} // namespace mpm_granular::Output

#endif
