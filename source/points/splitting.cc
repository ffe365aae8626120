#include <mpm_granular/points/points_by_cell.h>
#include <mpm_granular/points/splitting.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Less room to both sides than this part of an edge of the cell is none.
    constexpr double least_room = 1e-3;

    /// Ways along which shape functions are linear: all edges of a simplex.
    template <int dim>
    std::vector<Tensor<1, dim>>
    straight_ways(const Mesh::BackgroundMesh<dim> &mesh,
                  const Mesh::SimplexCell<dim>    &cell)
    {
      std::vector<Tensor<1, dim>> ways;
      for (unsigned int i = 0; i < cell.node.size(); ++i)
        for (unsigned int j = i + 1; j < cell.node.size(); ++j)
          ways.push_back(mesh.node_position(cell.node[j]) -
                         mesh.node_position(cell.node[i]));
      return ways;
    }

    /// Those of a box.
    template <int dim>
    std::vector<Tensor<1, dim>>
    straight_ways(const Mesh::BackgroundMesh<dim> &mesh,
                  const Mesh::BoxCell<dim>        &cell)
    {
      std::vector<Tensor<1, dim>> ways;
      for (unsigned int d = 0; d < dim; ++d)
        ways.push_back(
          mesh.node_position(cell.node[Mesh::BoxCell<dim>::end_of_edge(d)]) -
          mesh.node_position(cell.node[0]));
      return ways;
    }

    /// From a point to one of its halves: along the way with the most room to
    /// both sides, a quarter of the edge of a box of the point's volume, but at
    /// most half of the room. Zero if there is no room.
    template <class Cell>
    Tensor<1, Cell::dim>
    way_to_half(const Cell                              &cell,
                const std::vector<Tensor<1, Cell::dim>> &ways,
                const Point<Cell::dim>                  &place,
                const double                             volume)
    {
      const auto           heights = cell.heights(place);
      double               longest = 0.;
      Tensor<1, Cell::dim> chosen;
      for (const auto &way : ways)
        {
          double room = std::numeric_limits<double>::max(); // over the way
          for (unsigned int f = 0; f < Cell::n_faces; ++f)
            {
              const double slope = std::abs(cell.inward(f) * way);
              if (slope * room > heights[f])
                room = heights[f] / slope;
            }
          const double length = way.norm();
          // The first of equal ones, whatever round-off.
          if (room > least_room && room * length > (1. + 1e-9) * longest)
            {
              longest = room * length;
              chosen =
                way * std::min(.5 * room,
                               .25 * std::pow(volume, 1. / Cell::dim) / length);
            }
        }
      return chosen;
    }

    /// Puts a copy of a point behind all points.
    template <int dim>
    void
    copy_behind(PointArrays<dim> &points, const unsigned int p)
    {
      points.for_each_array([&](auto &array) {
        const typename std::decay_t<decltype(array)>::value_type value =
          array[p];
        array.push_back(value);
      });
    }
  } // namespace

  template <int dim>
  std::size_t
  split(const Mesh::BackgroundMesh<dim> &mesh,
        PointArrays<dim>                &points,
        const unsigned int               least_per_cell)
  {
    const std::size_t n_old = points.size();
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      for (auto &list : points_by_cell(points))
        {
          if (list.size() >= least_per_cell)
            continue;
          const Cell &cell = cells[points.cell[list[0]]];
          const auto  ways = straight_ways(mesh, cell);
          for (unsigned int n = list.size(); n < least_per_cell;)
            {
              const auto largest =
                std::max_element(list.begin(),
                                 list.end(),
                                 [&](const auto a, const auto b) {
                                   return points.volume[a] < points.volume[b];
                                 });
              if (largest == list.end())
                break;
              const unsigned int p = *largest;
              const auto         way =
                way_to_half(cell, ways, points.location(p), points.volume[p]);
              if (way.norm_square() == 0.)
                {
                  list.erase(largest);
                  continue;
                }
              points.mass[p] *= .5;
              points.volume[p] *= .5;
              const unsigned int half = points.size();
              copy_behind(points, p);
              points.id[half] = half - n_old;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  points.position[d][p] -= way[d];
                  points.position[d][half] += way[d];
                }
              list.push_back(half);
              ++n;
            }
        }
    });
    return points.size() - n_old;
  }

  template std::size_t
  split(const Mesh::BackgroundMesh<2> &, PointArrays<2> &, const unsigned int);
  template std::size_t
  split(const Mesh::BackgroundMesh<3> &, PointArrays<3> &, const unsigned int);
} // namespace mpm_granular::Points
