#ifndef mpm_granular_benchmarks_scalar_step_h
#define mpm_granular_benchmarks_scalar_step_h

#include <mpm_granular/mesh/background_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace mpm_granular::Benchmarks
{
  /// What the computation is made of.
  struct ScalarCase
  {
    double bulk, shear;   ///< moduli [Pa]
    double cone_slope;    ///< m
    double fluidity;      ///< gamma [1/s]
    double gravity;       ///< along -z [m/s^2]
    double pic_rate;      ///< [1/s]
    double least_density; ///< below, a node takes no force [kg/m^3]

    /// By node, bit d: its velocity has no component d.
    std::vector<unsigned char> held;
  };

  /**
   * The time step as a plain scalar loop, to see what the program gains by
   * being written otherwise: MUSL with the re-mapped momentum from the
   * consistent mass matrix, Perzyna's flow on the cone with exponent 1, a
   * tracked gap, lumped mass, tetrahedra, one process. The equations are those
   * of the program, one pass over the points, which are structures, ordered by
   * cell from time to time; what depends on the cell alone is computed once for
   * points in sequence.
   *
   * @tparam Number double, or a type that counts operations.
   */
  template <class Number>
  class ScalarStep
  {
  public:
    using Cell   = Mesh::SimplexCell<3>;
    using Vector = std::array<Number, 3>;
    using Matrix = std::array<Vector, 3>;

    struct Point
    {
      Vector                x, v;
      std::array<Number, 6> stress; ///< xx, yy, zz, xy, yz, zx
      Number                mass, volume, strain, log_volume_ratio;
      unsigned int          cell;
    };

    ScalarStep(const Mesh::BackgroundMesh<3> &mesh,
               const ScalarCase              &given,
               std::vector<Point>             initial_points)
      : points(std::move(initial_points))
      , mesh(mesh)
      , cells(mesh.cells<Cell>())
      , given(given)
      , slot_of_cell(cells.size(), none)
      , slot_of_node(mesh.n_nodes(), none)
    {
      for (auto &point : points)
        add_to_cell(point, shape_values(cells[point.cell], point.x));
    }

    void
    advance(const double dt)
    {
      gather_nodes();
      move_nodes(dt);
      for (const unsigned int cell : active_cells)
        slot_of_cell[cell] = none;
      active_cells.clear();
      cell_sums.clear();

      std::size_t  n_runs = 0;
      unsigned int cell   = none;
      Motion       motion;
      for (auto &point : points)
        {
          if (point.cell != cell)
            {
              cell   = point.cell;
              motion = motion_in(cells[cell], dt);
              ++n_runs;
            }
          move(point, cells[cell], motion, dt);
          strain(point, motion, dt);
          add_to_cell(point, find_cell(point));
        }
      keep_order(n_runs);
      for (const unsigned int node : active_nodes)
        slot_of_node[node] = none;
    }

    std::vector<Point> points;

  private:
    static constexpr unsigned int none = Mesh::no_cell;

    using ShapeValues = std::array<Number, 4>;

    struct CellSums
    {
      std::array<std::array<Number, 4>, 4> mass{};
      std::array<Vector, 4>                momentum{};
      std::array<Number, 6>                stress{};
    };

    struct Node
    {
      Number mass{};
      Vector momentum{}, force{}, velocity{}, change{}, straining{};
    };

    /// What a step does to the points of a cell.
    struct Motion
    {
      Vector velocity, change; ///< at the cell's origin
      Matrix velocity_gradient, change_gradient;
      Matrix rotation, strain; ///< deviatoric, rotated
      Number volume_ratio, log_volume_ratio;
      double kept; ///< of the points' velocity
    };

    static ShapeValues
    shape_values(const Cell &cell, const Vector &x)
    {
      ShapeValues values;
      values[0] = 1.;
      for (unsigned int k = 0; k < 3; ++k)
        {
          values[k + 1] = cell.gradient[k][0] * (x[0] - cell.origin[0]) +
                          cell.gradient[k][1] * (x[1] - cell.origin[1]) +
                          cell.gradient[k][2] * (x[2] - cell.origin[2]);
          values[0] = values[0] - values[k + 1];
        }
      return values;
    }

    /// Walks to the cell that holds the point.
    /// @return the shape values there, none of them of the size of round-off.
    ShapeValues
    find_cell(Point &point) const
    {
      constexpr double least = 1e-10, tolerance = -1e-12;
      ShapeValues      values = shape_values(cells[point.cell], point.x);
      if (*std::min_element(values.begin(), values.end()) >= least)
        return values;
      while (true)
        {
          const auto  &neighbor = cells[point.cell].neighbor;
          unsigned int exit     = none;
          Number       lowest   = tolerance;
          for (unsigned int f = 0; f < 4; ++f)
            if (neighbor[f] != none && values[f] < lowest)
              {
                lowest = values[f];
                exit   = neighbor[f];
              }
          if (exit == none)
            break;
          point.cell = exit;
          values     = shape_values(cells[exit], point.x);
        }
      Number sum = 0.;
      for (auto &value : values)
        {
          value = std::max(value, Number(least));
          sum   = sum + value;
        }
      for (auto &value : values)
        value = value / sum;
      return values;
    }

    void
    add_to_cell(const Point &point, const ShapeValues &values)
    {
      if (slot_of_cell[point.cell] == none)
        {
          slot_of_cell[point.cell] = active_cells.size();
          active_cells.push_back(point.cell);
          cell_sums.emplace_back();
        }
      CellSums &sums = cell_sums[slot_of_cell[point.cell]];
      for (unsigned int i = 0; i < 4; ++i)
        {
          const Number weighted = point.mass * values[i];
          for (unsigned int j = 0; j < 4; ++j)
            sums.mass[i][j] = sums.mass[i][j] + weighted * values[j];
          for (unsigned int d = 0; d < 3; ++d)
            sums.momentum[i][d] = sums.momentum[i][d] + weighted * point.v[d];
        }
      for (unsigned int s = 0; s < 6; ++s)
        sums.stress[s] = sums.stress[s] + point.volume * point.stress[s];
    }

    void
    gather_nodes()
    {
      active_nodes.clear();
      nodes.clear();
      for (unsigned int c = 0; c < active_cells.size(); ++c)
        {
          const Cell     &cell = cells[active_cells[c]];
          const CellSums &sums = cell_sums[c];
          const auto     &s    = sums.stress;
          const Matrix    stress{{Vector{{s[0], s[3], s[5]}},
                                  Vector{{s[3], s[1], s[4]}},
                                  Vector{{s[5], s[4], s[2]}}}};
          for (unsigned int k = 0; k < 4; ++k)
            {
              if (slot_of_node[cell.node[k]] == none)
                {
                  slot_of_node[cell.node[k]] = active_nodes.size();
                  active_nodes.push_back(cell.node[k]);
                  nodes.emplace_back();
                }
              Node &node = nodes[slot_of_node[cell.node[k]]];
              for (unsigned int j = 0; j < 4; ++j)
                node.mass = node.mass + sums.mass[k][j];
              const auto gradient = cell.shape_gradient(k);
              for (unsigned int d = 0; d < 3; ++d)
                {
                  node.momentum[d] = node.momentum[d] + sums.momentum[k][d];
                  for (unsigned int j = 0; j < 3; ++j)
                    node.force[d] = node.force[d] - stress[d][j] * gradient[j];
                }
            }
        }
    }

    void
    move_nodes(const double dt)
    {
      const double kept = 1. - std::min(1., given.pic_rate * dt);
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          Node        &node    = nodes[i];
          const Number inverse = 1. / node.mass;
          const bool   is_heavy =
            node.mass > given.least_density * mesh.node_volume(active_nodes[i]);
          for (unsigned int d = 0; d < 3; ++d)
            {
              Number force = is_heavy ? node.force[d] : Number(0.);
              if (d == 2)
                force = force - node.mass * given.gravity;
              const bool is_held = given.held[active_nodes[i]] >> d & 1;
              node.velocity[d]   = is_held ?
                                     Number(0.) :
                                     (node.momentum[d] + dt * force) * inverse;
              node.change[d] =
                node.velocity[d] - kept * (node.momentum[d] * inverse);
              node.straining[d] = kept * node.momentum[d];
            }
        }
      // The momentum of the points after the step, seen from the nodes.
      for (unsigned int c = 0; c < active_cells.size(); ++c)
        {
          std::array<Node *, 4> of_cell;
          for (unsigned int k = 0; k < 4; ++k)
            of_cell[k] = &nodes[slot_of_node[cells[active_cells[c]].node[k]]];
          for (unsigned int i = 0; i < 4; ++i)
            for (unsigned int j = 0; j < 4; ++j)
              for (unsigned int d = 0; d < 3; ++d)
                of_cell[i]->straining[d] =
                  of_cell[i]->straining[d] +
                  cell_sums[c].mass[i][j] * of_cell[j]->change[d];
        }
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const bool is_held = given.held[active_nodes[i]] >> d & 1;
            nodes[i].straining[d] =
              is_held ? Number(0.) : nodes[i].straining[d] / nodes[i].mass;
          }
    }

    static Matrix
    product(const Matrix &A, const Matrix &B)
    {
      Matrix result{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i][j] =
            A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
      return result;
    }

    static Matrix
    transpose(const Matrix &A)
    {
      return {{Vector{{A[0][0], A[1][0], A[2][0]}},
               Vector{{A[0][1], A[1][1], A[2][1]}},
               Vector{{A[0][2], A[1][2], A[2][2]}}}};
    }

    /// The rotation of a vector of tan(angle/2), or any multiple of it with the
    /// corresponding scalar part @p a.
    static Matrix
    rotation_of(const Number a, const Vector &b)
    {
      const Number square = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
      const Number scale  = 2. / (a * a + square);
      Matrix       result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i][j] = scale * (b[i] * b[j] - (i == j ? square : Number(0.)));
      const std::array<unsigned int, 3> next{{1, 2, 0}}, last{{2, 0, 1}};
      for (unsigned int i = 0; i < 3; ++i)
        {
          result[i][i] = result[i][i] + 1.;
          result[last[i]][next[i]] =
            result[last[i]][next[i]] + scale * a * b[i];
          result[next[i]][last[i]] =
            result[next[i]][last[i]] - scale * a * b[i];
        }
      return result;
    }

    Motion
    motion_in(const Cell &cell, const double dt) const
    {
      Motion                      motion;
      std::array<const Node *, 4> of_cell;
      for (unsigned int k = 0; k < 4; ++k)
        of_cell[k] = &nodes[slot_of_node[cell.node[k]]];
      motion.kept     = 1. - std::min(1., given.pic_rate * dt);
      motion.velocity = of_cell[0]->velocity;
      motion.change   = of_cell[0]->change;
      Matrix A{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            Number velocity = 0., change = 0., straining = 0.;
            for (unsigned int k = 0; k < 3; ++k)
              {
                const double g    = cell.gradient[k][j];
                const Node  &node = *of_cell[k + 1];
                velocity =
                  velocity + (node.velocity[i] - of_cell[0]->velocity[i]) * g;
                change = change + (node.change[i] - of_cell[0]->change[i]) * g;
                straining = straining +
                            (node.straining[i] - of_cell[0]->straining[i]) * g;
              }
            motion.velocity_gradient[i][j] = velocity;
            motion.change_gradient[i][j]   = change;
            A[i][j]                        = dt * straining;
          }

      const Number minor_x = A[1][1] * A[2][2] - A[1][2] * A[2][1];
      const Number minor_y = A[0][0] * A[2][2] - A[0][2] * A[2][0];
      const Number minor_z = A[0][0] * A[1][1] - A[0][1] * A[1][0];
      const Number change  = (A[0][0] + A[1][1] + A[2][2]) +
                            (minor_x + minor_y + minor_z) + A[0][0] * minor_x -
                            A[0][1] * (A[1][0] * A[2][2] - A[1][2] * A[2][0]) +
                            A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
      motion.volume_ratio     = 1. + change;
      const Number y          = change / (2. + change);
      const Number y2         = y * y;
      motion.log_volume_ratio = // the series of the logarithm
        2. * y * (1. + y2 * (1. / 3. + y2 * (1. / 5. + y2 * (1. / 7.))));

      const Vector h{{.125 * (A[2][1] - A[1][2]),
                      .125 * (A[0][2] - A[2][0]),
                      .125 * (A[1][0] - A[0][1])}};
      const Matrix half = rotation_of(1., h);
      motion.rotation   = product(half, half);
      const Number mean = (A[0][0] + A[1][1] + A[2][2]) * (1. / 3.);
      Matrix       e;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          e[i][j] = .5 * (A[i][j] + A[j][i]) - (i == j ? mean : Number(0.));
      motion.strain = product(product(half, e), transpose(half));
      return motion;
    }

    static void
    move(Point &point, const Cell &cell, const Motion &motion, const double dt)
    {
      Vector offset;
      for (unsigned int d = 0; d < 3; ++d)
        offset[d] = point.x[d] - cell.origin[d];
      for (unsigned int d = 0; d < 3; ++d)
        {
          Number velocity = motion.velocity[d], change = motion.change[d];
          for (unsigned int j = 0; j < 3; ++j)
            {
              velocity = velocity + motion.velocity_gradient[d][j] * offset[j];
              change   = change + motion.change_gradient[d][j] * offset[j];
            }
          point.v[d] = motion.kept * point.v[d] + change;
          point.x[d] = point.x[d] + dt * velocity;
        }
    }

    void
    strain(Point &point, const Motion &motion, const double dt) const
    {
      point.volume           = point.volume * motion.volume_ratio;
      point.log_volume_ratio = point.log_volume_ratio + motion.log_volume_ratio;
      const Number pressure =
        std::max(-given.bulk * point.log_volume_ratio, Number(0.));

      auto        &s    = point.stress;
      const Number mean = (s[0] + s[1] + s[2]) * (1. / 3.);
      const Matrix old{{Vector{{s[0] - mean, s[3], s[5]}},
                        Vector{{s[3], s[1] - mean, s[4]}},
                        Vector{{s[5], s[4], s[2] - mean}}}};
      const Matrix half = product(motion.rotation, old);
      constexpr std::array<std::array<unsigned int, 2>, 6> index{
        {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{1, 2}}, {{2, 0}}}};
      std::array<Number, 6> trial;
      for (unsigned int c = 0; c < 6; ++c)
        {
          const auto [i, j] = index[c];
          trial[c]          = half[i][0] * motion.rotation[j][0] +
                     half[i][1] * motion.rotation[j][1] +
                     half[i][2] * motion.rotation[j][2] +
                     2. * given.shear * motion.strain[i][j];
        }
      using std::sqrt;
      const Number q = sqrt(
        1.5 *
          (trial[0] * trial[0] + trial[1] * trial[1] + trial[2] * trial[2]) +
        3. * (trial[3] * trial[3] + trial[4] * trial[4] + trial[5] * trial[5]));
      const Number yield  = given.cone_slope * pressure;
      const double flow   = 3. * given.shear * given.fluidity * dt;
      Number       factor = 1.;
      if (q > yield)
        factor = yield * (q + flow) / ((yield + flow) * q);
      point.strain =
        point.strain + q * (1. - factor) * (1. / (3. * given.shear));
      for (unsigned int c = 0; c < 6; ++c)
        s[c] = trial[c] * factor - (c < 3 ? pressure : Number(0.));
    }

    /// Orders the points by cell where they have become so mixed that it pays.
    void
    keep_order(const std::size_t n_runs)
    {
      constexpr double too_many = 1.2;
      if (n_runs_in_order == 0)
        n_runs_in_order = n_runs;
      else if (n_runs > too_many * n_runs_in_order)
        {
          std::vector<unsigned int> first(cells.size() + 1, 0);
          for (const auto &point : points)
            ++first[point.cell + 1];
          for (unsigned int cell = 0; cell < cells.size(); ++cell)
            first[cell + 1] += first[cell];
          std::vector<Point> ordered(points.size());
          for (const auto &point : points)
            ordered[first[point.cell]++] = point;
          points.swap(ordered);
          n_runs_in_order = 0;
        }
    }

    const Mesh::BackgroundMesh<3> &mesh;
    const std::vector<Cell>       &cells;
    const ScalarCase              &given;
    std::vector<unsigned int>      slot_of_cell, slot_of_node;
    std::vector<unsigned int>      active_cells, active_nodes;
    std::vector<CellSums>          cell_sums;
    std::vector<Node>              nodes;
    std::size_t                    n_runs_in_order = 0;
  };
} // namespace mpm_granular::Benchmarks

#endif
