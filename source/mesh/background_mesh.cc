#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/rtree.h>

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/point_walk.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  template <int dim>
  BackgroundMesh<dim>::BackgroundMesh(const MeshSource<dim> &source,
                                      const std::string     &input_file,
                                      const MPI_Comm         communicator)
    : communicator(communicator)
    , kind(source.cell_kind())
  {
    if (kind == CellKind::simplex)
      {
        tria      = std::make_unique<Triangulation<dim>>();
        fe        = std::make_unique<FE_SimplexP<dim>>(1);
        map       = std::make_unique<MappingFE<dim>>(*fe);
        all_cells = std::vector<SimplexCell<dim>>();
      }
    else
      {
        // Cells get new owners by repartition() only: not while the points
        // have to follow refined cells.
        auto distributed = std::make_unique<Distributed>(
          communicator,
          Triangulation<dim>::none,
          Distributed::no_automatic_repartitioning);
        p4est     = distributed.get();
        tria      = std::move(distributed);
        fe        = std::make_unique<FE_Q<dim>>(1);
        map       = std::make_unique<MappingQ<dim>>(1);
        all_cells = std::vector<BoxCell<dim>>();
      }
    names      = source.make(*tria, input_file);
    refinement = std::make_unique<Refinement<dim>>(*tria);
    if (p4est != nullptr)
      p4est->repartition();
    fill();
  }

  template <int dim>
  void
  BackgroundMesh<dim>::repartition(const std::vector<std::uint32_t> &weights)
  {
    Assert(p4est != nullptr, ExcInternalError());
    AssertDimension(weights.size(), n_own);
    const auto connection = p4est->signals.weight.connect(
      [&](const typename Triangulation<dim>::cell_iterator &cell,
          const typename Triangulation<dim>::CellStatus) -> unsigned int {
        return weights[flat_index(CellIterator(cell))];
      });
    p4est->repartition();
    connection.disconnect();
    fill();
  }

  template <int dim>
  std::optional<std::vector<unsigned int>>
  BackgroundMesh<dim>::adapt(const std::vector<std::uint8_t> &wanted_levels)
  {
    AssertDimension(wanted_levels.size(), n_cells());
    std::vector<std::uint8_t> of_active_cells(tria->n_active_cells(), 0);
    std::vector<CellId>       before;
    for (unsigned int cell = 0; cell < n_own; ++cell)
      {
        of_active_cells[iterators[cell]->active_cell_index()] =
          wanted_levels[cell];
        before.push_back(iterators[cell]->id());
      }
    if (!refinement->adapt(of_active_cells))
      return {};
    fill();
    return cells_now(before);
  }

  template <int dim>
  std::vector<unsigned int>
  BackgroundMesh<dim>::cells_now(const std::vector<CellId> &before) const
  {
    std::vector<unsigned int> result;
    for (const CellId &id : before)
      {
        auto cell = tria->create_cell_iterator(
          CellId(id.get_coarse_cell_id(), 0, nullptr));
        for (const auto child : id.get_child_indices())
          if (cell->has_children())
            cell = cell->child(child);
        while (cell->has_children())
          cell = cell->child(0);
        result.push_back(flat_index(CellIterator(cell)));
      }
    return result;
  }

  template <int dim>
  std::vector<std::uint8_t>
  BackgroundMesh<dim>::refinement_tree() const
  {
    return refinement->tree();
  }

  template <int dim>
  void
  BackgroundMesh<dim>::set_refinement_tree(
    const std::vector<std::uint8_t> &tree)
  {
    refinement->grow(tree);
    fill();
  }

  template <int dim>
  std::vector<unsigned int>
  BackgroundMesh<dim>::free_nodes(const unsigned int cell) const
  {
    std::vector<unsigned int> result;
    for (const unsigned int node : nodes(cell))
      if (const auto *entries = hanging.get_constraint_entries(node))
        for (const auto &entry : *entries)
          result.push_back(entry.first);
      else
        result.push_back(node);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  template <int dim>
  void
  BackgroundMesh<dim>::interpolate_to_hanging_nodes(
    std::vector<double> &values,
    const unsigned int   n_values) const
  {
    AssertDimension(values.size(), n_nodes() * n_values);
    for (const auto &line : hanging.get_lines())
      for (unsigned int v = 0; v < n_values; ++v)
        {
          double sum = 0.;
          for (const auto &[free, weight] : line.entries)
            sum += weight * values[free * n_values + v];
          values[line.index * n_values + v] = sum;
        }
  }

  template <int dim>
  template <class Data>
  void
  BackgroundMesh<dim>::send_to_ghosts(
    const std::function<Data(const unsigned int)>               &pack,
    const std::function<void(const unsigned int, const Data &)> &unpack) const
  {
    if (p4est == nullptr)
      return;
    GridTools::exchange_cell_data_to_ghosts<Data, Triangulation<dim>>(
      *tria,
      [&](const CellIterator &cell) { return pack(flat_index(cell)); },
      [&](const CellIterator &cell, const Data &data) {
        unpack(flat_index(cell), data);
      });
  }

  template <int dim>
  std::string
  as_text(const Point<dim> &x)
  {
    std::ostringstream text;
    text << '(';
    for (unsigned int d = 0; d < dim; ++d)
      text << (d > 0 ? ", " : "") << x[d];
    text << ") m";
    return text.str();
  }

  template <int dim>
  ReferenceCell
  BackgroundMesh<dim>::reference_cell() const
  {
    return kind == CellKind::simplex ? ReferenceCells::get_simplex<dim>() :
                                       ReferenceCells::get_hypercube<dim>();
  }

  template <int dim>
  unsigned int
  BackgroundMesh<dim>::local_cell(const unsigned int global_cell) const
  {
    if (global_cell >= first_own && global_cell < first_own + n_own)
      return global_cell - first_own;
    const auto ghost =
      std::lower_bound(ghosts.begin(), ghosts.end(), global_cell);
    return ghost != ghosts.end() && *ghost == global_cell ?
             n_own + (ghost - ghosts.begin()) :
             unknown_cell;
  }

  template <int dim>
  unsigned int
  BackgroundMesh<dim>::owner(const unsigned int global_cell) const
  {
    return std::upper_bound(first_of_rank.begin(),
                            first_of_rank.end(),
                            global_cell) -
           first_of_rank.begin() - 1;
  }

  template <int dim>
  double
  BackgroundMesh<dim>::altitude(const unsigned int index) const
  {
    return visit([&](const auto &cells) {
      using Cell      = typename std::decay_t<decltype(cells)>::value_type;
      double steepest = 0.;
      for (unsigned int f = 0; f < Cell::n_faces; ++f)
        steepest = std::max(steepest, cells[index].inward(f).norm());
      return 1. / steepest;
    });
  }

  template <int dim>
  std::vector<unsigned int>
  BackgroundMesh<dim>::locate(const std::vector<Point<dim>> &places) const
  {
    std::vector<BoundingBox<dim>> boxes;
    for (const auto &cell : iterators)
      boxes.push_back(cell->bounding_box());
    const auto tree   = pack_rtree_of_indices(boxes);
    namespace bgi     = boost::geometry::index;
    const double near = 1e-6 * mean_cell_size();

    std::vector<unsigned int> result, is_found;
    for (const auto &x : places)
      {
        // A place on a face just outside of the box around its cell still
        // counts; one on a face between cells goes to the first of them.
        BoundingBox<dim> around(std::make_pair(x, x));
        around.extend(near);
        unsigned int best  = no_cell;
        double       depth = -boundary_tolerance;
        for (const auto candidate :
             tree | bgi::adaptors::queried(bgi::intersects(around)))
          {
            const double lowest = visit([&](const auto &cells) {
              const auto heights = cells[candidate].heights(x);
              return *std::min_element(heights.begin(), heights.end());
            });
            if (lowest > depth || (lowest == depth && best != no_cell &&
                                   global_cell(candidate) < global_cell(best)))
              {
                depth = lowest;
                best  = candidate;
              }
          }
        is_found.push_back(best != no_cell);
        result.push_back(best == no_cell || best < n_own ? best : unknown_cell);
      }
    if (is_distributed())
      {
        Utilities::MPI::max(is_found, communicator, is_found);
        for (unsigned int i = 0; i < result.size(); ++i)
          if (is_found[i] && result[i] == no_cell)
            result[i] = unknown_cell;
      }
    return result;
  }

  template <int dim>
  std::pair<double, double>
  BackgroundMesh<dim>::extent(const Tensor<1, dim> &direction) const
  {
    double lowest  = std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::lowest();
    for (const auto &x : node_positions)
      {
        lowest  = std::min(lowest, direction * x);
        highest = std::max(highest, direction * x);
      }
    if (!is_distributed())
      return {lowest, highest};
    return {Utilities::MPI::min(lowest, communicator),
            Utilities::MPI::max(highest, communicator)};
  }

  template <int dim>
  std::size_t
  BackgroundMesh<dim>::memory_consumption() const
  {
    const std::size_t of_cells = visit(
      [](const auto &cells) { return cells.capacity() * sizeof(cells[0]); });
    return tria->memory_consumption() + refinement->memory_consumption() +
           dofs.memory_consumption() + of_cells +
           n_cells() *
             (sizeof(double) + sizeof(CellIterator) + sizeof(unsigned int)) +
           n_nodes() * (sizeof(Point<dim>) + sizeof(double) +
                        sizeof(types::global_dof_index)) +
           faces.size() * sizeof(BoundaryFace<dim>);
  }

  template class BackgroundMesh<2>;
  template class BackgroundMesh<3>;
  template std::string
  as_text(const Point<2> &);
  template std::string
  as_text(const Point<3> &);
#define INSTANTIATE(dim, Data)                       \
  template void BackgroundMesh<dim>::send_to_ghosts( \
    const std::function<Data(const unsigned int)> &, \
    const std::function<void(const unsigned int, const Data &)> &) const;
  // What Adaptivity::State sends.
  INSTANTIATE(2, unsigned int)
  INSTANTIATE(3, unsigned int)
  // What Partition sends.
  INSTANTIATE(2, std::vector<unsigned int>)
  INSTANTIATE(3, std::vector<unsigned int>)
#undef INSTANTIATE
} // namespace mpm_granular::Mesh
