#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/rtree.h>

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/cell_order.h>
#include <mpm_granular/mesh/point_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <unordered_map>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    /// The same cell as one that knows its DoFs.
    template <int dim>
    typename DoFHandler<dim>::active_cell_iterator
    dofs_of(const typename BackgroundMesh<dim>::CellIterator &cell,
            const DoFHandler<dim>                            &dofs)
    {
      return {&dofs.get_triangulation(), cell->level(), cell->index(), &dofs};
    }

    /// The face of a cell of the triangulation with the cell's own number @p f
    /// of a face: simplices number it by the vertex opposite.
    template <int dim>
    unsigned int
    face_number(const SimplexCell<dim> &,
                const typename BackgroundMesh<dim>::CellIterator &cell,
                const unsigned int                                f)
    {
      for (const unsigned int face : cell->face_indices())
        {
          bool is_opposite = true;
          for (unsigned int v = 0; v < dim; ++v)
            is_opposite = is_opposite && cell->face(face)->vertex_index(v) !=
                                           cell->vertex_index(f);
          if (is_opposite)
            return face;
        }
      Assert(false, ExcInternalError());
      return 0;
    }

    template <int dim>
    unsigned int
    face_number(const BoxCell<dim> &,
                const typename BackgroundMesh<dim>::CellIterator &,
                const unsigned int f)
    {
      return f;
    }
  } // namespace

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
  void
  BackgroundMesh<dim>::fill()
  {
    dofs.reinit(*tria);
    dofs.distribute_dofs(*fe);
    order_cells();
    number_cells_globally();
    number_nodes();
    std::visit(
      [&](auto &cells) {
        fill_cells(cells);
        fill_faces(cells);
      },
      all_cells);
    complete_nodes();
    find_node_volumes();
    measure();
  }

  template <int dim>
  void
  BackgroundMesh<dim>::order_cells()
  {
    iterators =
      p4est != nullptr ? morton_order<dim>(*p4est) : hilbert_order<dim>(*tria);
    flat_indices.assign(tria->n_active_cells(), unknown_cell);
    n_own = 0;
    for (unsigned int index = 0; index < iterators.size(); ++index)
      {
        flat_indices[iterators[index]->active_cell_index()] = index;
        if (p4est == nullptr || iterators[index]->is_locally_owned())
          ++n_own;
      }
  }

  template <int dim>
  void
  BackgroundMesh<dim>::number_cells_globally()
  {
    first_of_rank.assign(1, 0);
    if (p4est == nullptr)
      first_of_rank.push_back(n_own);
    else
      for (const unsigned int n :
           Utilities::MPI::all_gather(communicator, n_own))
        first_of_rank.push_back(first_of_rank.back() + n);
    first_own = p4est == nullptr ?
                  0 :
                  first_of_rank[Utilities::MPI::this_mpi_process(communicator)];

    ghosts.resize(n_cells() - n_own);
    send_to_ghosts<unsigned int>(
      [&](const unsigned int cell) { return first_own + cell; },
      [&](const unsigned int cell, const unsigned int &global) {
        ghosts[cell - n_own] = global;
      });
    Assert(std::is_sorted(ghosts.begin(), ghosts.end()), ExcInternalError());
  }

  template <int dim>
  void
  BackgroundMesh<dim>::number_nodes()
  {
    std::unordered_map<types::global_dof_index, unsigned int> node_of;
    std::vector<types::global_dof_index> on_cell(fe->n_dofs_per_cell());
    global_nodes.clear();
    std::visit(
      [&](auto &cells) {
        cells.resize(iterators.size());
        for (unsigned int index = 0; index < iterators.size(); ++index)
          {
            dofs_of<dim>(iterators[index], dofs)->get_dof_indices(on_cell);
            for (unsigned int k = 0; k < on_cell.size(); ++k)
              {
                const auto [entry, is_new] =
                  node_of.emplace(on_cell[k], global_nodes.size());
                if (is_new)
                  global_nodes.push_back(on_cell[k]);
                cells[index].node[k] = entry->second;
              }
          }
      },
      all_cells);
  }

  template <int dim>
  template <class Cell>
  void
  BackgroundMesh<dim>::fill_cells(std::vector<Cell> &cells)
  {
    volumes.resize(cells.size());
    node_positions.resize(global_nodes.size());
    for (unsigned int index = 0; index < cells.size(); ++index)
      {
        const auto    &iterator = iterators[index];
        Cell          &cell     = cells[index];
        Tensor<2, dim> edges; // row d: vertex at the end of edge d minus first
        for (unsigned int d = 0; d < dim; ++d)
          edges[d] =
            iterator->vertex(Cell::end_of_edge(d)) - iterator->vertex(0);
        const double det = determinant(edges);
        volumes[index]   = det * Cell::reference_volume;
        if (!(det > 0.))
          throw InputError("The mesh has an inverted or flat cell at " +
                           as_text(iterator->center()) +
                           "; every cell must have a positive volume.");

        // x - x_0 = sum_d xi_d edge_d, so the columns of the inverse are the
        // gradients of xi_d.
        const Tensor<2, dim> inverse = invert(edges);
        for (unsigned int d = 0; d < dim; ++d)
          {
            cell.origin[d] = iterator->vertex(0)[d];
            for (unsigned int k = 0; k < dim; ++k)
              cell.gradient[k][d] = inverse[d][k];
          }
        for (unsigned int k = 0; k < Cell::n_nodes; ++k)
          {
            const Point<dim> &vertex     = iterator->vertex(k);
            node_positions[cell.node[k]] = vertex;
            // The affine map must bring all vertices to those of the reference
            // cell.
            constexpr double tolerance = 1e-6;
            const auto       values    = cell.shape_values(vertex);
            if (!(std::abs(values[k] - 1.) < tolerance))
              throw InputError(
                "The mesh has a cell at " + as_text(iterator->center()) +
                " that is not box-like; hypercubes must be " +
                (dim == 2 ? "parallelograms" : "parallelepipeds") +
                ". Take simplices for such a geometry.");
          }
      }
  }

  template <int dim>
  template <class Cell>
  void
  BackgroundMesh<dim>::fill_faces(std::vector<Cell> &cells)
  {
    faces.clear();
    for (unsigned int index = 0; index < cells.size(); ++index)
      {
        Cell &cell = cells[index];
        for (unsigned int f = 0; f < Cell::n_faces; ++f)
          {
            const auto        &iterator = iterators[index];
            const unsigned int number   = face_number(cell, iterator, f);
            if (!iterator->at_boundary(number))
              {
                cell.neighbor[f] = neighbor_of(iterator, number);
                continue;
              }
            cell.neighbor[f] = no_cell;

            BoundaryFace<dim> face;
            face.boundary = iterator->face(number)->boundary_id();
            face.cell     = index;
            for (unsigned int k = 0; k < Cell::n_nodes; ++k)
              if (Cell::is_on_face(k, f))
                face.node.push_back(cell.node[k]);
            const Tensor<1, dim> across = cell.inward(f);
            face.normal                 = -across / across.norm();
            face.area = volumes[index] * across.norm() / Cell::cone_volume;
            faces.push_back(face);
          }
      }
  }

  template <int dim>
  unsigned int
  BackgroundMesh<dim>::neighbor_of(const CellIterator &cell,
                                   const unsigned int  face) const
  {
    auto             neighbor = cell->neighbor(face);
    const Point<dim> center   = cell->face(face)->center();
    while (neighbor->has_children())
      {
        auto   next    = neighbor->child(0);
        double nearest = std::numeric_limits<double>::max();
        for (unsigned int c = 0; c < neighbor->n_children(); ++c)
          {
            const auto   child    = neighbor->child(c);
            const double distance = child->center().distance(center);
            const bool   is_known =
              child->has_children() ||
              flat_index(CellIterator(child)) != unknown_cell;
            if (is_known && distance < nearest)
              {
                nearest = distance;
                next    = child;
              }
          }
        neighbor = next;
      }
    return flat_index(CellIterator(neighbor));
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
  void
  BackgroundMesh<dim>::measure()
  {
    const auto sum = [&](const double value) {
      return is_distributed() ? Utilities::MPI::sum(value, communicator) :
                                value;
    };

    std::pair<Point<dim>, Point<dim>> corners;
    for (unsigned int d = 0; d < dim; ++d)
      std::tie(corners.first[d], corners.second[d]) =
        extent(Point<dim>::unit_vector(d));
    box = BoundingBox<dim>(corners);

    const double from_cells =
      sum(std::accumulate(volumes.begin(), volumes.begin() + n_own, 0.));
    const int finest      = tria->n_global_levels() - 1;
    double    n_finest    = 0.;
    double    from_finest = 0.;
    for (unsigned int cell = 0; cell < n_own; ++cell)
      if (iterators[cell]->level() == finest)
        {
          from_finest += volumes[cell];
          ++n_finest;
        }
    mean_size = size_of_cell(sum(from_finest) / sum(n_finest));

    // The volume by the divergence theorem over the surface must be the sum of
    // the cells': a reader that garbles connectivity fails here.
    double from_surface = 0.;
    for (const auto &face : faces)
      if (face.cell < n_own)
        {
          Point<dim> center;
          for (const unsigned int node : face.node)
            center += node_positions[node] / double(face.node.size());
          from_surface +=
            face.area * face.normal * (center - corners.first) / dim;
        }
    from_surface = sum(from_surface);
    require(std::abs(from_cells - from_surface) <= 1e-8 * from_cells,
            "The mesh is not valid: its cells fill " +
              std::to_string(from_cells) + ", but its surface encloses " +
              std::to_string(from_surface) + ".");
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
