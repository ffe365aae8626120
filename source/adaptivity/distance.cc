#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <mpm_granular/adaptivity/distance.h>
#include <mpm_granular/adaptivity/level_entry.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  namespace
  {
    /// A place as far away as said to be near is not near, whatever round-off.
    constexpr double round_off = 1e-9;

    template <int dim>
    double
    distance_to(const std::array<Point<dim>, 2> &segment, const Point<dim> &x)
    {
      const Tensor<1, dim> edge = segment[1] - segment[0];
      const double         along =
        (x - segment[0]) * edge / std::max(edge.norm_square(), 1e-300);
      return x.distance(segment[0] + std::min(std::max(along, 0.), 1.) * edge);
    }

    double
    distance_to(const std::array<Point<3>, 3> &triangle, const Point<3> &x)
    {
      const Tensor<1, 3> a = triangle[1] - triangle[0],
                         b = triangle[2] - triangle[0], c = x - triangle[0];
      const double det = a * a * (b * b) - a * b * (a * b);
      const double s   = (c * a * (b * b) - c * b * (a * b)) / det;
      const double t   = (c * b * (a * a) - c * a * (a * b)) / det;
      if (s >= 0. && t >= 0. && s + t <= 1.)
        return (c - s * a - t * b).norm();
      double least = std::numeric_limits<double>::max();
      for (unsigned int k = 0; k < 3; ++k)
        least =
          std::min(least,
                   distance_to<3>({{triangle[k], triangle[(k + 1) % 3]}}, x));
      return least;
    }
  } // namespace

  template <int dim>
  void
  Distance<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Boundaries",
                      boundaries,
                      "Boundaries to be near to, by name or id.");
    prm.add_parameter("Surface",
                      text,
                      "Instead of boundaries: the distance to a surface as an "
                      "expression of x, y, z and t, negative on its other "
                      "side, say 'sqrt((x-2)^2+y^2)-0.5' for a cylinder. "
                      "Units: m.");
    prm.add_parameter("Distance",
                      near,
                      "Cells with a vertex that is nearer than this get the "
                      "level, and those that the surface runs through. "
                      "Units: m.",
                      Parameters::positive_number());
    add_level_entry(prm, level, "Level of the cells that are near");
  }

  template <int dim>
  void
  Distance<dim>::check() const
  {
    require(boundaries.empty() != text.empty(),
            "Either 'Boundaries' or 'Surface' must be given, to say what the "
            "distance is to; given: " +
              std::string(text.empty() ? "none." : "both."));
    if (!text.empty())
      expression.emplace(text, 1, "Surface");
  }

  template <int dim>
  void
  Distance<dim>::prepare(const State<dim> &state)
  {
    if (!text.empty())
      {
        of_nodes.resize(state.mesh.n_nodes());
        for (unsigned int node = 0; node < of_nodes.size(); ++node)
          of_nodes[node] =
            expression->value(state.mesh.node_position(node), state.time);
        return;
      }
    // Refinement divides the faces of a boundary, which as a whole stays.
    if (pieces.empty())
      find_pieces(state);
    of_nodes = distances_to_pieces(state);
  }

  template <int dim>
  void
  Distance<dim>::find_pieces(const State<dim> &state)
  {
    const auto                  &mesh = state.mesh;
    std::set<types::boundary_id> ids;
    for (const auto &boundary : boundaries)
      ids.insert(Mesh::id_by_name(mesh.boundary_names(), boundary, "boundary"));

    for (const auto &face : mesh.boundary_faces())
      if (ids.count(face.boundary) > 0 && face.cell < mesh.n_own_cells())
        // A parallelogram is two triangles.
        for (unsigned int first = 0; first + dim <= face.node.size(); ++first)
          {
            Piece piece;
            for (unsigned int k = 0; k < dim; ++k)
              piece[k] = mesh.node_position(face.node[first + k]);
            pieces.push_back(piece);
          }
    if (!mesh.is_distributed())
      return;
    std::vector<Piece> of_all;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(mesh.mpi_communicator(), pieces))
      of_all.insert(of_all.end(), of_rank.begin(), of_rank.end());
    pieces.swap(of_all);
  }

  template <int dim>
  std::vector<double>
  Distance<dim>::distances_to_pieces(const State<dim> &state) const
  {
    std::vector<BoundingBox<dim>> boxes;
    for (const auto &piece : pieces)
      boxes.emplace_back(std::vector<Point<dim>>(piece.begin(), piece.end()));
    const auto tree = pack_rtree_of_indices(boxes);
    namespace bgi   = boost::geometry::index;
    std::vector<double> distances(state.mesh.n_nodes(),
                                  std::numeric_limits<double>::max());
    for (unsigned int node = 0; node < distances.size(); ++node)
      {
        const Point<dim> &x = state.mesh.node_position(node);
        BoundingBox<dim>  around(std::make_pair(x, x));
        around.extend(near);
        for (const auto candidate :
             tree | bgi::adaptors::queried(bgi::intersects(around)))
          distances[node] =
            std::min(distances[node], distance_to(pieces[candidate], x));
      }
    return distances;
  }

  template <int dim>
  unsigned int
  Distance<dim>::wanted_level(const State<dim>  &state,
                              const unsigned int cell) const
  {
    const auto   nodes         = state.mesh.nodes(cell);
    const bool   is_first_over = of_nodes[nodes[0]] > 0.;
    const double least         = (1. - round_off) * near;
    for (const unsigned int node : nodes)
      if (std::abs(of_nodes[node]) < least ||
          (of_nodes[node] > 0.) != is_first_over)
        return level;
    return 0;
  }

  template class Distance<2>;
  template class Distance<3>;

  namespace
  {
    const std::string documentation =
      "cells near boundaries, or near a surface given as a function.";
    const CriterionRegistry<2>::Entry<Distance<2>> distance_2d("distance",
                                                               documentation);
    const CriterionRegistry<3>::Entry<Distance<3>> distance_3d("distance",
                                                               documentation);
  } // namespace
} // namespace mpm_granular::Adaptivity
