// The tables of a mesh: cells with their geometry and neighbours, in the order
// they are stored in, boundary faces, and what is measured of the whole.

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/cell_order.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

  template class BackgroundMesh<2>;
  template class BackgroundMesh<3>;
} // namespace mpm_granular::Mesh
