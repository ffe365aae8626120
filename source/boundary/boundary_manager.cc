#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <mpm_granular/boundary/boundary_manager.h>

#include <map>
#include <set>

namespace mpm_granular::Boundary
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;

    /// Faces whose normals differ by less than this belong to one curved
    /// surface, with one normal at their common node: cos(45 degrees).
    constexpr double same_surface = 0.7071;

    /// What is left of a direction after the ones before it has to be more than
    /// this to count as a direction of its own.
    constexpr double independent = 1e-3;

    /// Adds a face's normal to those of a node, weighted by the face's area.
    template <int dim>
    void
    add_normal(std::vector<Tensor<1, dim>>   &normals,
               const Mesh::BoundaryFace<dim> &face)
    {
      for (auto &normal : normals)
        if (normal * face.normal > same_surface * normal.norm())
          {
            normal += face.area * face.normal;
            return;
          }
      normals.push_back(face.area * face.normal);
    }
  } // namespace

  template <int dim>
  BoundarySetting<dim>::BoundarySetting()
    : condition("free")
  {}

  template <int dim>
  void
  BoundarySetting<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Boundaries",
                      boundaries,
                      "Boundaries the condition is for, by their names in the "
                      "mesh file (x_min, x_max, ... for a box) or their ids.");
    condition.add_parameters(prm,
                             "Type",
                             "What holds or loads the material there:");
  }

  template <int dim>
  void
  BoundarySetting<dim>::check() const
  {
    condition->check();
  }

  template <int dim>
  BoundaryManager<dim>::BoundaryManager(const BoundarySettings<dim> &settings,
                                        const Mesh::BackgroundMesh<dim> &mesh)
    : mesh(mesh)
    , entry_of_node(mesh.n_nodes(), none)
  {
    find_directions(settings);
  }

  template <int dim>
  void
  BoundaryManager<dim>::find_directions(const BoundarySettings<dim> &settings)
  {
    std::set<types::boundary_id> without_condition;
    for (const auto &face : mesh.boundary_faces())
      without_condition.insert(face.boundary);

    for (const auto &name : settings.all_names())
      {
        const auto &setting   = settings[name];
        const auto &condition = *setting.condition;

        std::set<types::boundary_id> ids;
        for (const auto &boundary : setting.boundaries)
          ids.insert(
            Mesh::id_by_name(mesh.boundary_names(), boundary, "boundary"));
        for (const auto id : ids)
          without_condition.erase(id);

        std::map<unsigned int, std::vector<Tensor<1, dim>>> normals;
        for (const auto &face : mesh.boundary_faces())
          if (ids.count(face.boundary) > 0)
            {
              for (const unsigned int node : face.node)
                add_normal(normals[node], face);
              if (condition.has_traction())
                loaded_faces.push_back({&condition, face});
            }

        for (const auto &[node, node_normals] : normals)
          for (const auto &normal : node_normals)
            for (const auto &given :
                 condition.prescribed_directions(normal / normal.norm()))
              {
                if (entry_of_node[node] == none)
                  {
                    entry_of_node[node] = nodes.size();
                    nodes.emplace_back();
                    nodes.back().node = node;
                  }
                Node          &entry      = nodes[entry_of_node[node]];
                auto          &constraint = entry.constraint;
                Tensor<1, dim> rest       = given;
                for (unsigned int k = 0; k < constraint.n_directions; ++k)
                  rest -=
                    (rest * constraint.direction[k]) * constraint.direction[k];
                if (rest.norm() > independent)
                  {
                    constraint.direction[constraint.n_directions++] =
                      rest / rest.norm();
                    entry.directions.push_back({&condition, given});
                    entry.moves = entry.moves || !condition.is_at_rest();
                  }
              }
      }

    std::string open;
    for (const auto id : without_condition)
      {
        std::string boundary = "id " + std::to_string(id);
        for (const auto &[name, named_id] : mesh.boundary_names())
          if (named_id == id)
            boundary = name;
        open += (open.empty() ? "" : ", ") + boundary;
      }
    require(
      open.empty(),
      "No boundary condition for: " + open +
        ". Give one under 'Boundary conditions' ('free' leaves a boundary "
        "open).");
  }

  template <int dim>
  void
  BoundaryManager<dim>::update(const Grid::NodalFields<dim> &fields,
                               const double                  time,
                               const double                  time_step)
  {
    active.nodes.clear();
    for (unsigned int slot = 0; slot < fields.n_active_nodes(); ++slot)
      {
        const unsigned int entry = entry_of_node[fields.active_nodes[slot]];
        if (entry == none)
          continue;
        Node &node = nodes[entry];
        if (node.moves)
          set_targets(node, time, time_step);
        active.nodes.push_back(node.constraint);
        active.nodes.back().slot = slot;
      }
  }

  template <int dim>
  void
  BoundaryManager<dim>::set_targets(Node        &node,
                                    const double time,
                                    const double time_step) const
  {
    auto &constraint = node.constraint;
    for (unsigned int k = 0; k < node.directions.size(); ++k)
      {
        const Direction     &direction = node.directions[k];
        const Tensor<1, dim> velocity =
          direction.condition->velocity(mesh.node_position(node.node),
                                        time,
                                        time_step);
        // The given direction is the sum of its components along the
        // orthonormal ones; so is the velocity along it.
        double target = velocity * direction.given;
        for (unsigned int j = 0; j < k; ++j)
          target -=
            (direction.given * constraint.direction[j]) * constraint.target[j];
        constraint.target[k] =
          target / (direction.given * constraint.direction[k]);
      }
  }

  template <int dim>
  void
  BoundaryManager<dim>::add_tractions(Grid::NodalFields<dim> &fields,
                                      const double            time) const
  {
    if (loaded_faces.empty())
      return;
    const QGaussSimplex<dim - 1> quadrature(2);
    double                       reference_area = 0.;
    for (const double weight : quadrature.get_weights())
      reference_area += weight;

    // A face is loaded if any rank has points in its cell.
    std::vector<unsigned int> has_points;
    for (const auto &loaded : loaded_faces)
      has_points.push_back(fields.is_active_cell(loaded.face.cell));
    Utilities::MPI::max(has_points, fields.shared.communicator(), has_points);

    for (unsigned int f = 0; f < loaded_faces.size(); ++f)
      if (has_points[f])
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const auto             &loaded = loaded_faces[f];
            std::array<double, dim> shape_values; // on the face's nodes
            shape_values[0] = 1.;
            for (unsigned int k = 1; k < dim; ++k)
              {
                shape_values[k] = quadrature.point(q)[k - 1];
                shape_values[0] -= shape_values[k];
              }
            Point<dim> place;
            for (unsigned int k = 0; k < dim; ++k)
              place +=
                shape_values[k] * mesh.node_position(loaded.face.node[k]);
            const Tensor<1, dim> force =
              loaded.face.area * quadrature.weight(q) / reference_area *
              loaded.condition->traction(place, time);
            for (unsigned int k = 0; k < dim; ++k)
              if (fields.is_active_node(loaded.face.node[k]))
                fields.sums[fields.slot_of(loaded.face.node[k])].load +=
                  shape_values[k] * force;
          }
  }

  template struct BoundarySetting<2>;
  template struct BoundarySetting<3>;
  template class BoundaryManager<2>;
  template class BoundaryManager<3>;
} // namespace mpm_granular::Boundary
