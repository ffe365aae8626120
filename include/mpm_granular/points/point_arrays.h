#ifndef mpm_granular_points_point_arrays_h
#define mpm_granular_points_point_arrays_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/core/stress_layout.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mpm_granular::Points
{
  /**
   * Consecutive points [begin, end) of the arrays that share a host cell (and,
   * where a law is called, a material). With linear simplices they share the
   * velocity gradient, so that kinematics is computed once per run.
   */
  struct Run
  {
    unsigned int begin;
    unsigned int end;
  };

  /**
   * The state of the material points as a structure of arrays, in the order of
   * their host cells. Every loop of the time step runs on it.
   *
   * A point whose cell changes keeps its place until the next ordering; order
   * is a matter of speed, never of correctness.
   */
  template <int dim>
  struct PointArrays
  {
    using Array = std::vector<double>;

    std::array<Array, dim> position; ///< [m]
    std::array<Array, dim> velocity; ///< [m/s]
    std::array<Array, n_stress<dim>>
                       stress;  ///< Cauchy stress, tension > 0 [Pa]
    Array              mass;    ///< [kg], in 2D [kg/m]
    Array              volume;  ///< current volume [m^3], in 2D [m^2]
    std::vector<Array> history; ///< slots of the laws, then of the transfer

    std::vector<unsigned int>  cell;     ///< flat index of the host cell
    std::vector<std::uint32_t> id;       ///< never changes
    std::vector<std::uint8_t>  material; ///< index of the constitutive law

    std::size_t
    size() const
    {
      return cell.size();
    }

    /// Keeps the points there are; what is added is zero.
    void
    resize(const std::size_t n_points, const unsigned int n_history);

    /// Keeps the points that are listed, in the order of the list.
    void
    keep(const std::vector<unsigned int> &list);

    /// The position of point @p index.
    dealii::Point<dim>
    location(const std::size_t index) const
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = position[d][index];
      return x;
    }

    /// p = -tr(sigma)/3 of point @p index, positive in compression [Pa].
    double
    pressure(const std::size_t index) const
    {
      return -(1. / 3.) *
             (stress[0][index] + stress[1][index] + stress[2][index]);
    }

    /// Names of the arrays in the order of for_each_array().
    /// @param history_names names of the slots of the constitutive laws.
    static std::vector<std::string>
    array_names(const std::vector<std::string> &history_names);

    /// Calls @p action with every array, of whatever element type: the one
    /// list of what a point consists of.
    template <class Action>
    void
    for_each_array(Action &&action)
    {
      for (auto &array : position)
        action(array);
      for (auto &array : velocity)
        action(array);
      for (auto &array : stress)
        action(array);
      action(mass);
      action(volume);
      for (auto &array : history)
        action(array);
      action(cell);
      action(id);
      action(material);
    }
  };
} // namespace mpm_granular::Points

#endif
