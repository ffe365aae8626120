#ifndef tests_transfer_scattered_points_h
#define tests_transfer_scattered_points_h

#include "../box_mesh.h"
#include "../jittered_box.h"
#include "../seeds.h"

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/points/material_points.h>
#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/points_to_grid.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace Test
{
  /// Points all over the unit box, with irregular masses and given velocities,
  /// and a grid.
  template <int dim>
  struct ScatteredPoints
  {
    Mesh::BackgroundMesh<dim>   mesh;
    Mesh::Partition<dim>        partition;
    Points::MaterialPoints<dim> points;
    Grid::NodalFields<dim>      fields;
    Transfer::PointBlock<dim>   block;

    ScatteredPoints(
      const Mesh::MeshSource<dim>                             &source,
      const std::function<Tensor<1, dim>(const Point<dim> &)> &velocity,
      const MPI_Comm                  communicator  = MPI_COMM_SELF,
      const std::vector<std::string> &history_names = {})
      : mesh(source, "", communicator)
      , partition({}, mesh, communicator)
      , points(mesh, partition, history_names)
      , fields(mesh, partition)
    {
      // Steps of which no two or three are in proportion fill the box evenly.
      constexpr double spread[] = {.8191725134, .6710436067, .5497004779};
      std::vector<Point<dim>> places(3000);
      for (unsigned int i = 0; i < places.size(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          places[i][d] = .1 + .8 * std::fmod((i + 1) * spread[d], 1.);
      auto seeds = seeds_at(mesh, places, 1e-3);
      for (auto &seed : seeds)
        seed.volume *= 1. + scattered(seed.index);
      points.insert(seeds, 0, 1000.);
      points.load();
      auto &arrays = points.arrays();
      for (unsigned int p = 0; p < arrays.size(); ++p)
        {
          const Tensor<1, dim> v = velocity(arrays.location(p));
          for (unsigned int d = 0; d < dim; ++d)
            arrays.velocity[d][p] = v[d];
          for (unsigned int s = 0; s < n_stress<dim>; ++s)
            arrays.stress[s][p] = scattered(9 * arrays.id[p] + s);
        }
    }

    /// Refines the mesh near a place, to several levels, and lets the points
    /// follow.
    void
    refine_near(const Point<dim> &center)
    {
      for (unsigned int time = 0; time < 3; ++time)
        {
          points.release();
          points.send_home();
          std::vector<std::uint8_t> wanted;
          for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
            {
              const double distance =
                mesh.cell_iterator(cell)->center().distance(center);
              wanted.push_back(std::max(0., 3.5 - distance / .12));
            }
          points.pull_inside();
          if (const auto cells = mesh.adapt(wanted))
            {
              points.follow(*cells);
              const auto n_points = points.count_by_cell();
              points.release();
              partition.distribute(n_points);
              fields.reinit();
              points.send_home();
            }
        }
    }

    template <class Action>
    void
    for_each_block(Action &&action)
    {
      auto &arrays = points.arrays();
      for (unsigned int next = 0; next < arrays.size(); next = block.end)
        {
          block.reinit(arrays, next);
          action();
        }
    }

    /// Points to grid.
    void
    project()
    {
      fields.clear_cells();
      for_each_block([&] {
        Transfer::find_shape_values(mesh, points.arrays(), block);
        Transfer::relocate(mesh, partition, points.arrays(), block);
        Transfer::add_mass_and_momentum(mesh, points.arrays(), block, fields);
        Transfer::add_stress(mesh, points.arrays(), block, fields);
      });
      fields.gather_nodes();
    }
  };
} // namespace Test

#endif
