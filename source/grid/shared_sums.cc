#include <deal.II/base/exceptions.h>

#include <mpm_granular/grid/shared_sums.h>

#include <algorithm>
#include <cstring>

namespace mpm_granular::Grid
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int bits_per_word = 64;
    static_assert(sizeof(std::uint64_t) == sizeof(double));

    std::size_t
    n_words(const std::size_t n_bits)
    {
      return (n_bits + bits_per_word - 1) / bits_per_word;
    }

    std::uint64_t
    word(const std::vector<double> &message, const std::size_t index)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &message[index], sizeof(bits));
      return bits;
    }
  } // namespace

  template <int dim>
  SharedSums<dim>::SharedSums(const Mesh::Partition<dim> &partition,
                              const Places Neighbor::*places)
    : partition(partition)
    , of_neighbor(places)
  {}

  template <int dim>
  bool
  SharedSums<dim>::has_come(const Link &link, const std::size_t i) const
  {
    return word(link.incoming, i / bits_per_word) >> (i % bits_per_word) & 1;
  }

  template <int dim>
  void
  SharedSums<dim>::exchange_active(const std::vector<double> &values,
                                   const unsigned int         n_values)
  {
    for (auto &link : links)
      {
        const std::size_t          n = link.slots.size();
        std::vector<std::uint64_t> bits(n_words(n), 0);
        link.outgoing.resize(bits.size());
        for (std::size_t i = 0; i < n; ++i)
          if (link.slots[i] != no_slot)
            {
              bits[i / bits_per_word] |= std::uint64_t(1)
                                         << (i % bits_per_word);
              const auto value = values.begin() + link.slots[i] * n_values;
              link.outgoing.insert(link.outgoing.end(),
                                   value,
                                   value + n_values);
            }
        std::memcpy(link.outgoing.data(),
                    bits.data(),
                    bits.size() * sizeof(bits[0]));
        link.incoming.resize(bits.size() + n * n_values);
      }
    exchange_messages();
  }

  template <int dim>
  std::vector<unsigned int>
  SharedSums<dim>::active_elsewhere() const
  {
    std::vector<unsigned int> found;
    for (unsigned int k = 0; k < links.size(); ++k)
      for (std::size_t i = 0; i < links[k].slots.size(); ++i)
        if (links[k].slots[i] == no_slot && has_come(links[k], i))
          found.push_back(places(k).places[i]);
    return found;
  }

  template <int dim>
  void
  SharedSums<dim>::sum_first(std::vector<double> &values,
                             const unsigned int   n_values)
  {
    for (const auto &link : links)
      for (const unsigned int slot : link.slots)
        if (slot != no_slot)
          n_active = std::max(n_active, slot + 1);
    values.resize(n_active * n_values);
    shared.clear();
    std::vector<char> is_shared(n_active, false); // by slot
    is_first.assign(n_active, true);
    for (unsigned int k = 0; k < links.size(); ++k)
      {
        Link             &link  = links[k];
        const std::size_t n     = link.slots.size();
        std::size_t       place = n_words(n);
        link.common.clear();
        link.place.clear();
        for (std::size_t i = 0; i < n; ++i)
          {
            // The neighbour adopts what is its own and active here.
            const bool is_sent = has_come(link, i);
            if (link.slots[i] != no_slot &&
                (is_sent || places(k).are_its_own[i]))
              {
                link.common.push_back(link.slots[i]);
                link.place.push_back(is_sent ? place : not_sent);
                if (!is_shared[link.slots[i]])
                  shared.push_back(link.slots[i]);
                is_shared[link.slots[i]] = true;
                if (partition.neighbors()[k].rank < partition.rank)
                  is_first[link.slots[i]] = false;
              }
            if (is_sent)
              place += n_values;
          }
      }
    add_up(values.data(), n_values);
  }

  template <int dim>
  void
  SharedSums<dim>::sum(double *values, const unsigned int n_values)
  {
    if (is_serial())
      return;
    for (auto &link : links)
      {
        const std::size_t n = link.common.size();
        link.outgoing.resize(n * n_values);
        link.incoming.resize(n * n_values);
        for (std::size_t i = 0; i < n; ++i)
          {
            std::copy_n(values + link.common[i] * n_values,
                        n_values,
                        link.outgoing.begin() + i * n_values);
            link.place[i] = i * n_values;
          }
      }
    exchange_messages();
    add_up(values, n_values);
  }

  template <int dim>
  void
  SharedSums<dim>::sum(std::vector<Tensor<1, dim>> &field)
  {
    if (is_serial())
      return;
    packed.resize(field.size() * dim);
    for (const unsigned int slot : shared)
      for (unsigned int d = 0; d < dim; ++d)
        packed[slot * dim + d] = field[slot][d];
    sum(packed.data(), dim);
    for (const unsigned int slot : shared)
      for (unsigned int d = 0; d < dim; ++d)
        field[slot][d] = packed[slot * dim + d];
  }

  template <int dim>
  void
  SharedSums<dim>::spread(std::vector<double> &values,
                          const unsigned int   n_values)
  {
    if (is_serial())
      return;
    for (unsigned int k = 0; k < links.size(); ++k)
      {
        links[k].outgoing.clear();
        for (const unsigned int place : places(k).places)
          links[k].outgoing.insert(links[k].outgoing.end(),
                                   values.begin() + place * n_values,
                                   values.begin() + (place + 1) * n_values);
        links[k].incoming.resize(links[k].outgoing.size());
      }
    exchange_messages();
    for (unsigned int k = 0; k < links.size(); ++k)
      {
        const auto &list = places(k).places;
        for (std::size_t i = 0; i < list.size(); ++i)
          for (unsigned int v = 0; v < n_values; ++v)
            values[list[i] * n_values + v] +=
              links[k].incoming[i * n_values + v];
      }
  }

  template <int dim>
  void
  SharedSums<dim>::exchange_messages()
  {
    constexpr int            tag = 7411;
    std::vector<MPI_Request> requests(2 * links.size());
    for (unsigned int k = 0; k < links.size(); ++k)
      {
        Link     &link  = links[k];
        const int rank  = partition.neighbors()[k].rank;
        int       error = MPI_Irecv(link.incoming.data(),
                              link.incoming.size(),
                              MPI_DOUBLE,
                              rank,
                              tag,
                              partition.communicator,
                              &requests[2 * k]);
        AssertThrowMPI(error);
        error = MPI_Isend(link.outgoing.data(),
                          link.outgoing.size(),
                          MPI_DOUBLE,
                          rank,
                          tag,
                          partition.communicator,
                          &requests[2 * k + 1]);
        AssertThrowMPI(error);
        ++sent.n_messages;
        sent.n_bytes += link.outgoing.size() * sizeof(double);
      }
    const int error =
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    AssertThrowMPI(error);
  }

  template <int dim>
  void
  SharedSums<dim>::add_up(double *values, const unsigned int n_values)
  {
    totals.resize(n_active * n_values);
    for (const unsigned int slot : shared)
      std::fill_n(totals.begin() + slot * n_values, n_values, 0.);
    const auto add_own = [&] {
      for (const unsigned int slot : shared)
        for (unsigned int v = 0; v < n_values; ++v)
          totals[slot * n_values + v] += values[slot * n_values + v];
    };

    bool own_is_added = false;
    for (unsigned int k = 0; k < links.size(); ++k)
      {
        if (!own_is_added && partition.neighbors()[k].rank > partition.rank)
          {
            add_own();
            own_is_added = true;
          }
        const Link &link = links[k];
        for (std::size_t i = 0; i < link.common.size(); ++i)
          if (link.place[i] != not_sent)
            for (unsigned int v = 0; v < n_values; ++v)
              totals[link.common[i] * n_values + v] +=
                link.incoming[link.place[i] + v];
      }
    if (!own_is_added)
      add_own();
    for (const unsigned int slot : shared)
      std::copy_n(totals.begin() + slot * n_values,
                  n_values,
                  values + slot * n_values);
  }

  template class SharedSums<2>;
  template class SharedSums<3>;
} // namespace mpm_granular::Grid
