#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <mpm_granular/points/migration.h>

#include <cstring>
#include <map>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    using Message = std::vector<char>;

    /// The chosen points, array after array.
    template <int dim>
    Message
    pack(PointArrays<dim> &points, const std::vector<unsigned int> &chosen)
    {
      Message message;
      points.for_each_array([&](auto &array) {
        for (const unsigned int p : chosen)
          {
            const char *bytes = reinterpret_cast<const char *>(&array[p]);
            message.insert(message.end(), bytes, bytes + sizeof(array[p]));
          }
      });
      return message;
    }

    /// What one point takes in a message.
    template <int dim>
    std::size_t
    bytes_per_point(PointArrays<dim> &points)
    {
      std::size_t n_bytes = 0;
      points.for_each_array([&](auto &array) { n_bytes += sizeof(array[0]); });
      return n_bytes;
    }

    template <int dim>
    void
    unpack_behind(PointArrays<dim> &points, const Message &message)
    {
      const std::size_t n_old = points.size();
      const std::size_t n_new = message.size() / bytes_per_point(points);
      points.resize(n_old + n_new, points.history.size());
      const char *bytes = message.data();
      points.for_each_array([&](auto &array) {
        std::memcpy(array.data() + n_old, bytes, n_new * sizeof(array[0]));
        bytes += n_new * sizeof(array[0]);
      });
      Assert(bytes == message.data() + message.size(), ExcInternalError());
    }
  } // namespace

  template <int dim>
  std::size_t
  migrate(const Mesh::Partition<dim> &partition, PointArrays<dim> &points)
  {
    if (partition.n_ranks == 1)
      return 0;
    std::vector<unsigned int>                         staying;
    std::map<unsigned int, std::vector<unsigned int>> leaving;
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        const unsigned int owner = points.cell[p] == Mesh::no_cell ?
                                     partition.rank :
                                     partition.owner(points.cell[p]);
        if (owner == partition.rank)
          staying.push_back(p);
        else
          leaving[owner].push_back(p);
      }

    std::map<unsigned int, Message> outgoing;
    for (const auto &[rank, chosen] : leaving)
      outgoing[rank] = pack(points, chosen);
    const std::size_t n_sent = points.size() - staying.size();
    points.keep(staying);

    for (const auto &[rank, message] :
         Utilities::MPI::some_to_some(partition.communicator, outgoing))
      unpack_behind(points, message);
    return n_sent;
  }

  template std::size_t
  migrate(const Mesh::Partition<2> &, PointArrays<2> &);
  template std::size_t
  migrate(const Mesh::Partition<3> &, PointArrays<3> &);
} // namespace mpm_granular::Points
