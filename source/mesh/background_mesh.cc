#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/numerics/rtree.h>

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/point_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Tensor<2, dim>
    edge_matrix(const typename BackgroundMesh<dim>::CellIterator &cell)
    {
      Tensor<2, dim> edges; // row k: vertex k+1 minus vertex 0
      for (unsigned int k = 0; k < dim; ++k)
        edges[k] = cell->vertex(k + 1) - cell->vertex(0);
      return edges;
    }

    /// The same cell as one that knows its DoFs.
    template <int dim>
    typename DoFHandler<dim>::active_cell_iterator
    dofs_of(const typename BackgroundMesh<dim>::CellIterator &cell,
            const DoFHandler<dim>                            &dofs)
    {
      return {&dofs.get_triangulation(), cell->level(), cell->index(), &dofs};
    }

    constexpr double
    factorial(const unsigned int n)
    {
      return n <= 1 ? 1. : n * factorial(n - 1);
    }

    /// Cells in the order in which a Hilbert curve passes their centres.
    template <int dim>
    std::vector<unsigned int>
    curve_order(const std::vector<Point<dim>> &centers)
    {
      // deal.II stretches the box around the places to a cube. A corner that
      // makes it one keeps near what is near, also in a slice or a channel.
      const BoundingBox<dim>  box(centers);
      std::vector<Point<dim>> places  = centers;
      Point<dim>              corner  = box.get_boundary_points().first;
      double                  longest = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        longest = std::max(longest, box.side_length(d));
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] += longest;
      places.push_back(corner);

      const int  bits = 64 / dim;
      const auto keys =
        Utilities::inverse_Hilbert_space_filling_curve(places, bits);

      std::vector<unsigned int> order(centers.size());
      std::iota(order.begin(), order.end(), 0u);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const unsigned int a, const unsigned int b) {
                         return keys[a] < keys[b];
                       });
      return order;
    }
  } // namespace

  /// Finds candidate cells for a place anywhere in the mesh.
  template <int dim>
  struct BackgroundMesh<dim>::Locator
  {
    std::vector<BoundingBox<dim>>          boxes;
    decltype(pack_rtree_of_indices(boxes)) tree;

    explicit Locator(const std::vector<CellIterator> &cells)
      : boxes(make_boxes(cells))
      , tree(pack_rtree_of_indices(boxes))
    {}

    static std::vector<BoundingBox<dim>>
    make_boxes(const std::vector<CellIterator> &cells)
    {
      std::vector<BoundingBox<dim>> boxes;
      for (const auto &cell : cells)
        boxes.push_back(cell->bounding_box());
      return boxes;
    }
  };

  template <int dim>
  BackgroundMesh<dim>::BackgroundMesh(const MeshSource<dim> &source,
                                      const std::string     &input_file)
    : fe(1)
    , map(fe)
    , dofs(tria)
    , names(source.make(tria, input_file))
  {
    dofs.distribute_dofs(fe);
    number_along_curve();
    fill_cells();
    fill_faces();
    box = BoundingBox<dim>(node_positions);
    check();
  }

  template <int dim>
  void
  BackgroundMesh<dim>::number_along_curve()
  {
    std::vector<CellIterator> given(tria.active_cell_iterators().begin(),
                                    tria.active_cell_iterators().end());
    std::vector<Point<dim>>   centers;
    for (const auto &cell : given)
      centers.push_back(cell->center());

    flat_indices.resize(given.size());
    for (const unsigned int index : curve_order(centers))
      {
        flat_indices[given[index]->active_cell_index()] = iterators.size();
        iterators.push_back(given[index]);
      }

    // Nodes in the order in which the cells meet them first.
    std::vector<types::global_dof_index> numbers(dofs.n_dofs(),
                                                 numbers::invalid_dof_index);
    std::vector<types::global_dof_index> on_cell(dim + 1);
    types::global_dof_index              next = 0;
    for (const auto &cell : iterators)
      {
        dofs_of<dim>(cell, dofs)->get_dof_indices(on_cell);
        for (const auto dof : on_cell)
          if (numbers[dof] == numbers::invalid_dof_index)
            numbers[dof] = next++;
      }
    dofs.renumber_dofs(numbers);
  }

  template <int dim>
  void
  BackgroundMesh<dim>::fill_cells()
  {
    cells.resize(iterators.size());
    volumes.resize(iterators.size());
    node_positions.resize(dofs.n_dofs());

    std::vector<types::global_dof_index> on_cell(dim + 1);
    for (unsigned int index = 0; index < iterators.size(); ++index)
      {
        const auto          &iterator = iterators[index];
        SimplexCell<dim>    &cell     = cells[index];
        const Tensor<2, dim> edges    = edge_matrix<dim>(iterator);
        const double         det      = determinant(edges);
        volumes[index]                = det / factorial(dim);
        if (!(det > 0.))
          throw InputError("The mesh has an inverted or flat cell at " +
                           as_text(iterator->center()) +
                           "; every simplex must have a positive volume.");

        // x - x_0 = sum_k N_k edge_k, so the columns of the inverse are the
        // gradients.
        const Tensor<2, dim> inverse = invert(edges);
        dofs_of<dim>(iterator, dofs)->get_dof_indices(on_cell);
        for (unsigned int d = 0; d < dim; ++d)
          {
            cell.origin[d] = iterator->vertex(0)[d];
            for (unsigned int k = 0; k < dim; ++k)
              cell.gradient[k][d] = inverse[d][k];
          }
        for (unsigned int k = 0; k <= dim; ++k)
          {
            cell.node[k]               = on_cell[k];
            node_positions[on_cell[k]] = iterator->vertex(k);
          }
      }
  }

  template <int dim>
  void
  BackgroundMesh<dim>::fill_faces()
  {
    for (unsigned int index = 0; index < cells.size(); ++index)
      {
        const auto       &iterator = iterators[index];
        SimplexCell<dim> &cell     = cells[index];
        for (const unsigned int f : iterator->face_indices())
          {
            // The one vertex that is not on the face.
            unsigned int opposite = 0;
            for (unsigned int k = 0; k <= dim; ++k)
              {
                bool on_face = false;
                for (unsigned int v = 0; v < dim; ++v)
                  on_face |= iterator->face(f)->vertex_index(v) ==
                             iterator->vertex_index(k);
                if (!on_face)
                  opposite = k;
              }

            if (!iterator->at_boundary(f))
              {
                cell.neighbor[opposite] =
                  flat_indices[iterator->neighbor(f)->active_cell_index()];
                continue;
              }
            cell.neighbor[opposite] = no_cell;

            BoundaryFace<dim> face;
            face.boundary  = iterator->face(f)->boundary_id();
            face.cell      = index;
            unsigned int v = 0;
            for (unsigned int k = 0; k <= dim; ++k)
              if (k != opposite)
                face.node[v++] = cell.node[k];
            // |grad N| = 1/altitude, and volume = area altitude / dim.
            const Tensor<1, dim> inward = cell.shape_gradient(opposite);
            face.normal                 = -inward / inward.norm();
            face.area                   = dim * volumes[index] * inward.norm();
            faces.push_back(face);
          }
      }
  }

  template <int dim>
  void
  BackgroundMesh<dim>::check() const
  {
    // The volume by the divergence theorem over the surface must be the sum of
    // the cells': a reader that garbles connectivity fails here.
    double from_surface = 0.;
    for (const auto &face : faces)
      {
        Point<dim> center;
        for (const unsigned int node : face.node)
          center += node_positions[node] / dim;
        from_surface +=
          face.area * face.normal * (center - node_positions[0]) / dim;
      }
    const double from_cells =
      std::accumulate(volumes.begin(), volumes.end(), 0.);
    if (std::abs(from_cells - from_surface) > 1e-8 * from_cells)
      throw InputError(
        "The mesh is not valid: its cells fill " + std::to_string(from_cells) +
        ", but its surface encloses " + std::to_string(from_surface) + ".");
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
  double
  BackgroundMesh<dim>::altitude(const unsigned int index) const
  {
    double steepest = 0.;
    for (unsigned int k = 0; k <= dim; ++k)
      steepest = std::max(steepest, cells[index].shape_gradient(k).norm());
    return 1. / steepest;
  }

  template <int dim>
  unsigned int
  BackgroundMesh<dim>::locate(const Point<dim> &x) const
  {
    if (!locator)
      locator = std::make_shared<Locator>(iterators);

    unsigned int best  = no_cell;
    double       depth = -boundary_tolerance;
    namespace bgi      = boost::geometry::index;
    // A place on a face just outside of the box around its cell still counts.
    BoundingBox<dim> around(std::make_pair(x, x));
    around.extend(1e-6 * mean_cell_size());
    for (const auto candidate :
         locator->tree | bgi::adaptors::queried(bgi::intersects(around)))
      {
        const auto   values = cells[candidate].shape_values(x);
        const double lowest = *std::min_element(values.begin(), values.end());
        if (lowest > depth || (lowest == depth && candidate < best))
          {
            depth = lowest;
            best  = candidate;
          }
      }
    return best;
  }

  template <int dim>
  double
  BackgroundMesh<dim>::mean_cell_size() const
  {
    const double total = std::accumulate(volumes.begin(), volumes.end(), 0.);
    return std::pow(factorial(dim) * total / volumes.size(), 1. / dim);
  }

  template <int dim>
  std::size_t
  BackgroundMesh<dim>::memory_consumption() const
  {
    return tria.memory_consumption() + dofs.memory_consumption() +
           n_cells() * (sizeof(SimplexCell<dim>) + sizeof(double) +
                        sizeof(CellIterator) + sizeof(unsigned int)) +
           n_nodes() * sizeof(Point<dim>) +
           faces.size() * sizeof(BoundaryFace<dim>);
  }

  template class BackgroundMesh<2>;
  template class BackgroundMesh<3>;
  template std::string
  as_text(const Point<2> &);
  template std::string
  as_text(const Point<3> &);
} // namespace mpm_granular::Mesh
