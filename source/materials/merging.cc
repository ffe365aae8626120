#include <mpm_granular/materials/merging.h>
#include <mpm_granular/materials/stress_columns.h>
#include <mpm_granular/points/points_by_cell.h>

#include <algorithm>
#include <tuple>

namespace mpm_granular::Materials
{
  using namespace dealii;

  namespace
  {
    /// Points that may become one; the first has the smaller id.
    struct Pair
    {
      double       square_distance; ///< [m^2]
      unsigned int first, second;
    };

    /// The pairs of points of a cell that have one material, nearest first.
    /// @param list of the points, by id.
    template <int dim>
    std::vector<Pair>
    pairs_of(const Points::PointArrays<dim>  &points,
             const std::vector<unsigned int> &list)
    {
      std::vector<Pair> pairs;
      for (unsigned int i = 0; i < list.size(); ++i)
        for (unsigned int j = i + 1; j < list.size(); ++j)
          if (points.material[list[i]] == points.material[list[j]])
            pairs.push_back({points.location(list[i]).distance_square(
                               points.location(list[j])),
                             list[i],
                             list[j]});
      std::stable_sort(pairs.begin(),
                       pairs.end(),
                       [](const Pair &a, const Pair &b) {
                         return a.square_distance < b.square_distance;
                       });
      return pairs;
    }

    template <int dim>
    double
    kinetic_energy(const Points::PointArrays<dim> &points, const unsigned int p)
    {
      double square = 0.;
      for (const auto &component : points.velocity)
        square += component[p] * component[p];
      return .5 * points.mass[p] * square;
    }

    template <int dim>
    double
    elastic_energy(Points::PointArrays<dim>   &points,
                   const ConstitutiveLaw<dim> &law,
                   const unsigned int          p)
    {
      return points.volume[p] *
             law.elastic_energy_density(StressColumns<dim>(points, p).load(0));
    }

    /// Makes @p first the mean and sum of both.
    template <int dim>
    void
    merge_pair(Points::PointArrays<dim>   &points,
               const ConstitutiveLaw<dim> &law,
               const Pair                 &pair,
               MergingLoss                &loss)
    {
      const unsigned int a = pair.first, b = pair.second;
      loss.n_points += 1;
      loss.kinetic += kinetic_energy(points, a) + kinetic_energy(points, b);
      loss.elastic +=
        elastic_energy(points, law, a) + elastic_energy(points, law, b);

      const auto average = [&](auto &array, const auto &weight) {
        array[a] = (weight[a] * array[a] + weight[b] * array[b]) /
                   (weight[a] + weight[b]);
      };
      for (auto &component : points.position)
        average(component, points.mass);
      for (auto &component : points.velocity)
        average(component, points.mass);
      for (auto &component : points.stress)
        average(component, points.volume);
      for (auto &slot : points.history)
        average(slot, points.volume);
      points.mass[a] += points.mass[b];
      points.volume[a] += points.volume[b];
      law.reconcile(points, {a, a + 1});

      loss.kinetic -= kinetic_energy(points, a);
      loss.elastic -= elastic_energy(points, law, a);
    }

    /// Merges pairs of a cell of which no two have a point in common.
    /// @param list of the points, by id; those that are gone are taken off.
    template <int dim>
    void
    merge_nearest(Points::PointArrays<dim>                        &points,
                  const std::vector<const ConstitutiveLaw<dim> *> &laws,
                  const unsigned int                               n_too_many,
                  std::vector<unsigned int>                       &list,
                  MergingLoss                                     &loss)
    {
      std::vector<unsigned int> touched, gone;
      const auto is_in = [](const auto &some, const unsigned int p) {
        return std::find(some.begin(), some.end(), p) != some.end();
      };
      for (const Pair &pair : pairs_of(points, list))
        {
          if (gone.size() == n_too_many)
            break;
          if (is_in(touched, pair.first) || is_in(touched, pair.second))
            continue;
          merge_pair(points, *laws[points.material[pair.first]], pair, loss);
          touched.insert(touched.end(), {pair.first, pair.second});
          gone.push_back(pair.second);
        }
      list.erase(std::remove_if(list.begin(),
                                list.end(),
                                [&](const unsigned int p) {
                                  return is_in(gone, p);
                                }),
                 list.end());
    }
  } // namespace

  template <int dim>
  MergingLoss
  merge(Points::PointArrays<dim>                        &points,
        const std::vector<const ConstitutiveLaw<dim> *> &laws,
        const unsigned int                               most_per_cell)
  {
    MergingLoss               loss;
    std::vector<unsigned int> staying;
    for (auto &list : Points::points_by_cell(points))
      {
        // Points of several materials can be more than that.
        std::size_t before = list.size() + 1;
        while (list.size() > most_per_cell && list.size() < before)
          {
            before = list.size();
            merge_nearest(
              points, laws, list.size() - most_per_cell, list, loss);
          }
        staying.insert(staying.end(), list.begin(), list.end());
      }
    if (loss.n_points > 0)
      {
        std::sort(staying.begin(), staying.end());
        points.keep(staying);
      }
    return loss;
  }

  template MergingLoss
  merge(Points::PointArrays<2> &,
        const std::vector<const ConstitutiveLaw<2> *> &,
        const unsigned int);
  template MergingLoss
  merge(Points::PointArrays<3> &,
        const std::vector<const ConstitutiveLaw<3> *> &,
        const unsigned int);
} // namespace mpm_granular::Materials
