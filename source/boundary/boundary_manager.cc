#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/grid/reference_cell.h>

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
                                        const Mesh::BackgroundMesh<dim> &mesh,
                                        const MPI_Comm communicator)
    : settings(settings)
    , mesh(mesh)
    , communicator(communicator)
  {
    reinit();
  }

  template <int dim>
  void
  BoundaryManager<dim>::reinit()
  {
    entry_of_node.assign(mesh.n_nodes(), none);
    nodes.clear();
    loaded_faces.clear();

    std::set<types::boundary_id> without_condition;
    for (const auto &face : mesh.boundary_faces())
      without_condition.insert(face.boundary);
    if (mesh.is_distributed())
      without_condition =
        Utilities::MPI::compute_set_union(without_condition, communicator);

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

        // On all ranks, whether they have such faces or not.
        has_loads = has_loads || condition.has_traction();
        active.has_contact =
          active.has_contact || condition.contact_friction().has_value();
        std::map<unsigned int, std::vector<Tensor<1, dim>>> normals;
        for (const auto &face : mesh.boundary_faces())
          if (ids.count(face.boundary) > 0)
            {
              for (const unsigned int node : face.node)
                if (node != Mesh::unknown_node)
                  add_normal(normals[node], face);
              if (condition.has_traction() && face.cell != Mesh::unknown_cell)
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
                    constraint.contact_friction[constraint.n_directions] =
                      condition.contact_friction();
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
    find_active(fields,
                [&](Node &node) { set_targets(node, time, time_step); });
  }

  template <int dim>
  void
  BoundaryManager<dim>::update_at_rest(const Grid::NodalFields<dim> &fields)
  {
    find_active(fields, [](Node &node) { node.constraint.target.fill(0.); });
  }

  template <int dim>
  template <class SetTargets>
  void
  BoundaryManager<dim>::find_active(const Grid::NodalFields<dim> &fields,
                                    SetTargets                  &&set_targets)
  {
    active.nodes.clear();
    for (unsigned int slot = 0; slot < fields.n_active_nodes(); ++slot)
      {
        const unsigned int entry = entry_of_node[fields.active_nodes[slot]];
        if (entry == none)
          continue;
        Node &node = nodes[entry];
        if (node.moves)
          set_targets(node);
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
    if (!has_loads)
      return;
    // A face is loaded if any rank has points in its cell; the first of these
    // ranks adds the load, and nodes get the sum over the ranks.
    const auto                  is_first = is_first_in_cells(fields);
    std::vector<Tensor<1, dim>> loads(fields.n_active_nodes());

    const ReferenceCell face_cell =
      mesh.reference_cell().face_reference_cell(0);
    const auto quadrature =
      face_cell.template get_gauss_type_quadrature<dim - 1>(2);
    double reference_area = 0.;
    for (const double weight : quadrature.get_weights())
      reference_area += weight;

    for (unsigned int f = 0; f < loaded_faces.size(); ++f)
      if (is_first[f])
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const auto &condition   = *loaded_faces[f].condition;
            const auto &face        = loaded_faces[f].face;
            const auto  shape_value = [&](const unsigned int k) {
              return face_cell.d_linear_shape_function(quadrature.point(q), k);
            };
            Point<dim> place;
            for (unsigned int k = 0; k < face.node.size(); ++k)
              place += shape_value(k) * mesh.node_position(face.node[k]);
            const Tensor<1, dim> force = face.area * quadrature.weight(q) /
                                         reference_area *
                                         condition.traction(place, time);
            for (unsigned int k = 0; k < face.node.size(); ++k)
              fields.hanging.add_at(loads,
                                    fields.slot_of(face.node[k]),
                                    Tensor<1, dim>(shape_value(k) * force));
          }
    fields.shared.sum(loads);
    for (unsigned int slot = 0; slot < loads.size(); ++slot)
      fields.sums[slot].load += loads[slot];
  }

  template <int dim>
  std::vector<bool>
  BoundaryManager<dim>::is_first_in_cells(
    const Grid::NodalFields<dim> &fields) const
  {
    std::vector<bool>         result;
    std::vector<unsigned int> occupied; // global cells
    for (const auto &loaded : loaded_faces)
      {
        result.push_back(fields.is_active_cell(loaded.face.cell));
        if (result.back())
          occupied.push_back(mesh.global_cell(loaded.face.cell));
      }
    if (fields.shared.is_serial())
      return result;

    std::set<unsigned int> taken; // by ranks before this one
    const auto all = Utilities::MPI::all_gather(communicator, occupied);
    for (unsigned int r = 0; r < Utilities::MPI::this_mpi_process(communicator);
         ++r)
      taken.insert(all[r].begin(), all[r].end());
    for (unsigned int f = 0; f < result.size(); ++f)
      if (taken.count(mesh.global_cell(loaded_faces[f].face.cell)) > 0)
        result[f] = false;
    return result;
  }

  template struct BoundarySetting<2>;
  template struct BoundarySetting<3>;
  template class BoundaryManager<2>;
  template class BoundaryManager<3>;
} // namespace mpm_granular::Boundary
