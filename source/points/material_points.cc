#include <deal.II/base/mpi.h>

#include <mpm_granular/mesh/point_walk.h>
#include <mpm_granular/points/material_points.h>
#include <mpm_granular/points/migration.h>
#include <mpm_granular/points/splitting.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Calls @p action(property, slot) for the floating point numbers of a point
    /// in the order of the handler's properties: the one description of that
    /// order.
    template <int dim, class Action>
    void
    for_each_property(PointArrays<dim> &points, Action &&action)
    {
      unsigned int slot = 0;
      for (auto &array : points.velocity)
        action(array, slot++);
      for (auto &array : points.stress)
        action(array, slot++);
      action(points.mass, slot++);
      action(points.volume, slot++);
      for (auto &array : points.history)
        action(array, slot++);
    }

    template <int dim>
    unsigned int
    n_properties(const unsigned int n_history)
    {
      return dim + n_stress<dim> + 2 + n_history + 1; // the last: material
    }

    /// What the handler needs for a particle: two places, properties, id, and
    /// some bookkeeping; deal.II does not tell.
    template <int dim>
    std::size_t
    bytes_per_particle(const unsigned int n_history)
    {
      return (2 * dim + n_properties<dim>(n_history)) * sizeof(double) +
             2 * sizeof(types::particle_index) + 2 * sizeof(void *);
    }
  } // namespace

  template <int dim>
  MaterialPoints<dim>::MaterialPoints(const Mesh::BackgroundMesh<dim> &mesh,
                                      const Mesh::Partition<dim> &partition,
                                      std::vector<std::string>    history_names)
    : mesh(mesh)
    , partition(partition)
    , names(std::move(history_names))
    , particles(mesh.triangulation(),
                mesh.mapping(),
                n_properties<dim>(names.size()))
  {}

  template <int dim>
  std::vector<std::string>
  MaterialPoints<dim>::property_names() const
  {
    std::vector<std::string> list;
    for (unsigned int d = 0; d < dim; ++d)
      list.push_back("velocity");
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      list.push_back(std::string("stress_") + stress_name[s]);
    list.insert(list.end(), {"mass", "volume"});
    list.insert(list.end(), names.begin(), names.end());
    list.push_back("material");
    return list;
  }

  template <int dim>
  void
  MaterialPoints<dim>::insert(const std::vector<Seed<dim>> &seeds,
                              const unsigned int            material,
                              const double                  density)
  {
    std::uint64_t n_indices = 0;
    for (const auto &seed : seeds)
      n_indices = std::max(n_indices, seed.index + 1);
    n_indices = Utilities::MPI::max(n_indices, partition.communicator);
    require(n_ids + n_indices <=
              std::numeric_limits<types::particle_index>::max(),
            "There are more points than deal.II can count; it may be built "
            "with 64 bit indices.");

    std::vector<double> properties(n_properties<dim>(names.size()), 0.);
    for (const auto &seed : seeds)
      {
        if (!partition.is_owned(seed.cell))
          continue;
        properties[dim + n_stress<dim>]     = density * seed.volume;
        properties[dim + n_stress<dim> + 1] = seed.volume;
        properties.back()                   = material;
        particles.insert_particle(seed.position,
                                  mesh.reference_point(seed.cell,
                                                       seed.position),
                                  n_ids + seed.index,
                                  mesh.cell_iterator(seed.cell),
                                  make_array_view(properties));
      }
    n_ids += n_indices;
    particles.update_cached_numbers();
  }

  template <int dim>
  void
  MaterialPoints<dim>::clear()
  {
    working_set.resize(0, names.size());
    n_ids = 0;
  }

  template <int dim>
  void
  MaterialPoints<dim>::load()
  {
    working_set.resize(particles.n_locally_owned_particles(), names.size());
    unsigned int p = 0;
    for (const auto &particle : particles)
      {
        for (unsigned int d = 0; d < dim; ++d)
          working_set.position[d][p] = particle.get_location()[d];
        const auto properties = particle.get_properties();
        for_each_property<dim>(working_set,
                               [&](auto &array, const unsigned int slot) {
                                 array[p] = properties[slot];
                               });
        working_set.material[p] = static_cast<std::uint8_t>(
          properties[n_properties<dim>(names.size()) - 1]);
        working_set.id[p]   = particle.get_id();
        working_set.cell[p] = mesh.flat_index(particle.get_surrounding_cell());
        ++p;
      }
    particles.clear_particles();
    particles.update_cached_numbers();
    order();
  }

  template <int dim>
  void
  MaterialPoints<dim>::publish()
  {
    particles.clear_particles();
    std::vector<double> properties(n_properties<dim>(names.size()));
    for (unsigned int p = 0; p < working_set.size(); ++p)
      {
        for_each_property<dim>(working_set,
                               [&](auto &array, const unsigned int slot) {
                                 properties[slot] = array[p];
                               });
        properties.back() = working_set.material[p];
        particles.insert_particle(working_set.location(p),
                                  mesh.reference_point(working_set.cell[p],
                                                       working_set.location(p)),
                                  working_set.id[p],
                                  mesh.cell_iterator(working_set.cell[p]),
                                  make_array_view(properties));
      }
    particles.update_cached_numbers();
  }

  template <int dim>
  void
  MaterialPoints<dim>::order()
  {
    // A counting sort that touches only cells with points. A mark for each,
    // 64 in a word, finds them in order faster than sorting their numbers.
    constexpr unsigned int n_bits = 64;
    n_in_cell.resize(mesh.n_cells(), 0);
    is_occupied.resize(mesh.n_cells() / n_bits + 1, 0);
    for (const unsigned int cell : working_set.cell)
      {
        ++n_in_cell[cell];
        is_occupied[cell / n_bits] |= std::uint64_t(1) << cell % n_bits;
      }
    std::vector<unsigned int> occupied;
    unsigned int              next = 0;
    for (unsigned int word = 0; word < is_occupied.size(); ++word)
      for (auto marks = std::exchange(is_occupied[word], 0); marks != 0;
           marks &= marks - 1)
        {
          occupied.push_back(word * n_bits + __builtin_ctzll(marks));
          next += std::exchange(n_in_cell[occupied.back()], next);
        }

    std::vector<unsigned int> permutation(working_set.size());
    for (unsigned int p = 0; p < working_set.size(); ++p)
      permutation[n_in_cell[working_set.cell[p]]++] = p;
    for (const unsigned int cell : occupied)
      n_in_cell[cell] = 0;

    working_set.keep(permutation);
  }

  template <int dim>
  void
  MaterialPoints<dim>::release()
  {
    for (unsigned int &cell : working_set.cell)
      if (cell != Mesh::no_cell)
        cell = mesh.global_cell(cell);
  }

  template <int dim>
  void
  MaterialPoints<dim>::attach()
  {
    for (unsigned int &cell : working_set.cell)
      if (cell != Mesh::no_cell)
        cell = mesh.local_cell(cell);
  }

  template <int dim>
  std::size_t
  MaterialPoints<dim>::send_home()
  {
    const std::size_t n_sent = migrate(partition, working_set);
    attach();
    order();
    return n_sent;
  }

  template <int dim>
  void
  MaterialPoints<dim>::pull_inside()
  {
    mesh.visit([&](const auto &cells) {
      for (unsigned int p = 0; p < working_set.size(); ++p)
        {
          const auto       &cell    = cells[working_set.cell[p]];
          const Point<dim> &x       = working_set.location(p);
          const auto        heights = cell.heights(x);
          if (*std::min_element(heights.begin(), heights.end()) >=
              -Mesh::inside_tolerance)
            continue;
          const auto values = cell.inner_shape_values(x, 0.);
          Point<dim> inside;
          for (unsigned int k = 0; k < values.size(); ++k)
            inside += values[k] * mesh.node_position(cell.node[k]);
          for (unsigned int d = 0; d < dim; ++d)
            working_set.position[d][p] = inside[d];
        }
    });
  }

  template <int dim>
  void
  MaterialPoints<dim>::follow(const std::vector<unsigned int> &new_cells)
  {
    mesh.visit([&](const auto &cells) {
      for (unsigned int p = 0; p < working_set.size(); ++p)
        {
          const auto found = Mesh::walk_to(cells,
                                           working_set.location(p),
                                           new_cells[working_set.cell[p]]);
          AssertThrow(found.cell != Mesh::no_cell && !found.is_beyond_reach,
                      ExcInternalError());
          working_set.cell[p] = found.cell;
        }
    });
    order();
  }

  template <int dim>
  std::vector<std::uint32_t>
  MaterialPoints<dim>::count_by_cell(const std::uint32_t weight) const
  {
    std::vector<std::uint32_t> counts(mesh.n_cells(), 0);
    for (const unsigned int cell : working_set.cell)
      counts[cell] += weight;
    if (!mesh.is_distributed())
      Utilities::MPI::sum(counts, partition.communicator, counts);
    return counts;
  }

  template <int dim>
  std::size_t
  MaterialPoints<dim>::split(const unsigned int least_per_cell)
  {
    const std::size_t n_old = working_set.size();
    const std::size_t n_new = Points::split(mesh, working_set, least_per_cell);
    const auto        n_new_of_ranks =
      Utilities::MPI::all_gather(partition.communicator, n_new);
    const auto before = n_new_of_ranks.begin() + partition.rank;

    std::uint64_t first_id =
      std::accumulate(n_new_of_ranks.begin(), before, n_ids);
    n_ids = std::accumulate(before, n_new_of_ranks.end(), first_id);
    if (n_ids > std::numeric_limits<std::uint32_t>::max())
      throw ComputationError("So many points have been made by splitting that "
                             "there are no more numbers for them.");
    for (std::size_t p = n_old; p < working_set.size(); ++p)
      working_set.id[p] += first_id;
    if (n_new > 0)
      order();
    return n_new;
  }

  template <int dim>
  std::size_t
  MaterialPoints<dim>::remove_lost()
  {
    std::vector<unsigned int> kept;
    for (unsigned int p = 0; p < working_set.size(); ++p)
      if (working_set.cell[p] != Mesh::no_cell)
        kept.push_back(p);
    const std::size_t n_removed = working_set.size() - kept.size();
    if (n_removed > 0)
      working_set.keep(kept);
    return n_removed;
  }

  template <int dim>
  void
  MaterialPoints<dim>::serialize(Core::Archive &archive)
  {
    const auto   array_names = PointArrays<dim>::array_names(names);
    unsigned int index       = 0;
    archive.replicated("points/n_ids", n_ids);
    working_set.for_each_array([&](auto &array) {
      archive.distributed("points/" + array_names[index++], array);
    });
  }

  template <int dim>
  std::size_t
  MaterialPoints<dim>::memory_consumption() const
  {
    std::size_t bytes = particles.n_locally_owned_particles() *
                          bytes_per_particle<dim>(names.size()) +
                        n_in_cell.capacity() * sizeof(unsigned int) +
                        is_occupied.capacity() * sizeof(std::uint64_t);
    const_cast<PointArrays<dim> &>(working_set)
      .for_each_array(
        [&](auto &array) { bytes += array.capacity() * sizeof(array[0]); });
    return bytes;
  }

  template class MaterialPoints<2>;
  template class MaterialPoints<3>;
} // namespace mpm_granular::Points
