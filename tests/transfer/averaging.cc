// Means over cells and around nodes: a linear velocity field has its constant
// gradient at all points; forces add up to no force and no moment; a constant
// stress of points too many for the mesh acts on its volume, and in simplices,
// where gradients do not vary, on no inner node, however irregular the points
// are; and where cells are half empty, forces do the work of the stresses.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/nodal_pressure.h>

#include <iostream>
#include <limits>

using namespace Test;

template <int dim>
struct Averaged : ScatteredPoints<dim>
{
  std::unique_ptr<Transfer::Averaging<dim>> averaging;

  Averaged(const std::string           &name,
           const Mesh::MeshSource<dim> &source,
           const double                 filling)
    : ScatteredPoints<dim>(source,
                           [](const Point<dim> &) { return Tensor<1, dim>(); })
    , averaging(Transfer::AveragingRegistry<dim>::make(name))
  {
    averaging->reinit(this->mesh,
                      this->partition,
                      {std::numeric_limits<double>::infinity()});
    // All over the mesh.
    for (auto &coordinates : this->points.arrays().position)
      for (double &coordinate : coordinates)
        coordinate = (coordinate - .1) / .8;
    double volume = 0.;
    for (const double of_point : this->points.arrays().volume)
      volume += of_point;
    for (double &of_point : this->points.arrays().volume)
      of_point *= filling / volume;
  }

  void
  find_forces()
  {
    auto &arrays = this->points.arrays();
    auto &fields = this->fields;
    fields.clear_cells();
    averaging->clear();
    this->for_each_block([&] {
      Transfer::find_shape_values(this->mesh, arrays, this->block);
      Transfer::relocate(this->mesh, this->partition, arrays, this->block);
      Transfer::add_mass_and_momentum(this->mesh, arrays, this->block, fields);
      averaging->add_volumes(arrays, this->block, fields);
      averaging->add_stresses(arrays, this->block, fields);
    });
    fields.gather_nodes();
    averaging->find_weights(fields);
    averaging->find_forces(fields);
  }

  /// Sets the straining velocity of the nodes.
  template <class Velocity>
  void
  set_velocity(Velocity &&velocity)
  {
    for (unsigned int i = 0; i < this->fields.n_active_nodes(); ++i)
      this->fields.motion[i].straining = velocity(node(i));
    averaging->find_gradients(this->fields);
  }

  /// Calls @p action with every point and its velocity gradient.
  template <class Action>
  void
  for_each_gradient(Action &&action)
  {
    this->for_each_block([&] {
      auto &block = this->block;
      averaging->evaluate(this->fields, this->points.arrays(), block);
      for (unsigned int i = 0; i < block.strained.size(); ++i)
        for (unsigned int p = block.strained[i].begin;
             p < block.strained[i].end;
             ++p)
          action(p, block.gradients[i]);
    });
  }

  Point<dim>
  node(const unsigned int slot) const
  {
    return this->mesh.node_position(this->fields.active_nodes[slot]);
  }
};

template <int dim>
void
test(const std::string &name, const Mesh::MeshSource<dim> &source)
{
  const Tensor<2, dim> gradient = [] {
    Tensor<2, dim> G;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        G[i][j] = scattered(3 * i + j) - .5;
    return G;
  }();

  Averaged<dim> sparse(name, source, .3);
  sparse.find_forces();
  sparse.set_velocity([&](const Point<dim> &x) { return gradient * x; });
  double       worst_gradient = 0.;
  unsigned int n_strained     = 0;
  sparse.for_each_gradient([&](const unsigned int, const Tensor<2, dim> &L) {
    worst_gradient = std::max(worst_gradient, (L - gradient).norm());
    ++n_strained;
  });

  Tensor<1, dim> force;
  double         torque = 0., largest = 0., power = 0.;
  const auto     wavy = [](const Point<dim> &x) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = std::sin(3. * x[(d + 1) % dim] + d) * x[d];
    return v;
  };
  for (unsigned int i = 0; i < sparse.fields.n_active_nodes(); ++i)
    {
      const auto &f = sparse.fields.sums[i].force;
      const auto  x = sparse.node(i);
      force += f;
      torque += x[0] * f[1] - x[1] * f[0];
      largest = std::max(largest, f.norm());
      power += f * wavy(x);
    }
  sparse.set_velocity(wavy);
  const auto &points       = sparse.points.arrays();
  double      stress_power = 0.;
  sparse.for_each_gradient([&](const unsigned int p, const Tensor<2, dim> &L) {
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      {
        const unsigned int i = stress_index[s][0], j = stress_index[s][1];
        if (i < dim && j < dim)
          stress_power += points.volume[p] * points.stress[s][p] *
                          (i == j ? L[i][i] : L[i][j] + L[j][i]);
      }
  });

  Averaged<dim> full(name, source, 30.);
  for (auto &component : full.points.arrays().stress)
    std::fill(component.begin(), component.end(), 1.);
  full.find_forces();
  double on_inner = 0., on_outer = 0., virial = 0.;
  for (unsigned int i = 0; i < full.fields.n_active_nodes(); ++i)
    {
      const auto &f        = full.fields.sums[i].force;
      const auto  x        = full.node(i);
      bool        is_inner = true;
      for (unsigned int d = 0; d < dim; ++d)
        {
          is_inner &= x[d] > .01 && x[d] < .99;
          for (unsigned int e = 0; e < dim; ++e)
            virial -= x[d] * f[e] / (dim * dim);
        }
      double &worst = is_inner ? on_inner : on_outer;
      worst         = std::max(worst, f.norm());
    }
  const bool is_simplex = full.mesh.cell_kind() == Mesh::CellKind::simplex;

  double worst_pressure = 0.; // p = -1 at all points
  for (const double p :
       Transfer::nodal_pressure(full.mesh, full.points.arrays(), full.fields))
    worst_pressure = std::max(worst_pressure, std::abs(p + 1.));

  std::cout << dim << "D, " << name << (is_simplex ? "" : " in hypercubes")
            << ": gradients exact "
            << (worst_gradient < 1e-12 && n_strained == points.size())
            << ", no net force " << (force.norm() < 1e-12 * largest)
            << ", no net moment " << (std::abs(torque) < 1e-12 * largest)
            << std::endl
            << "forces do the work of stresses "
            << (std::abs(power + stress_power) < 1e-12 * std::abs(power))
            << ", constant stress fills the volume "
            << (std::abs(virial - 1.) < 1e-12)
            << (is_simplex ? ", acts at the boundary only " +
                               std::to_string(on_inner < 1e-12 * on_outer) :
                             "")
            << ", and is the nodes' pressure " << (worst_pressure < 1e-12)
            << std::endl;
}

/// What is chosen for a body, if that is left open.
template <int dim>
void
choose(const Mesh::MeshSource<dim> &source)
{
  Averaged<dim> body("automatic", source, 1.);
  auto         &averaging = *body.averaging;
  std::cout << dim << "D, automatic"
            << (body.mesh.cell_kind() == Mesh::CellKind::hypercube ?
                  " in hypercubes" :
                  "");
  for (const auto &traits :
       {Transfer::BodyTraits{4., true, false}, // enough points
        Transfer::BodyTraits{2.9, true, false},
        Transfer::BodyTraits{2.9, true, true}, // settled first
        Transfer::BodyTraits{2.9, false, false}})
    {
      if (averaging.suit(traits))
        averaging.reinit(body.mesh,
                         body.partition,
                         {std::numeric_limits<double>::infinity()});
      std::cout << ": " << averaging.name_in_use("automatic") << ' '
                << averaging.suitable_filter_rate() << ' '
                << averaging.suitable_shift_rate();
    }
  std::cout << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string name : {"cells", "nodes"})
    {
      test<2>(name, JitteredBox<2>(4));
      test<3>(name, JitteredBox<3>(4));
    }
  test<2>("cells", BoxMesh<2>("hypercubes", 4));
  test<3>("cells", BoxMesh<3>("hypercubes", 4));
  choose<2>(JitteredBox<2>(4));
  choose<3>(JitteredBox<3>(4));
  choose<3>(BoxMesh<3>("hypercubes", 4));
}
