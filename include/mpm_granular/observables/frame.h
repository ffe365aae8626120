#ifndef mpm_granular_observables_frame_h
#define mpm_granular_observables_frame_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/mesh/background_mesh.h>

#include <string>

namespace mpm_granular::Observables
{
  /**
   * Where "along" and "up" are, and from where they are measured: observables
   * never take x and z for granted.
   */
  template <int dim>
  struct Frame
  {
    /**
     * Collective.
     *
     * @param mesh the background mesh, whose nodes bound what is measured.
     * @param run_out direction of the run-out: x, y, z, or -x, -y, -z.
     * @param gravity [m/s^2]; where it is zero, up is the last axis.
     */
    Frame(const Mesh::BackgroundMesh<dim> &mesh,
          const std::string               &run_out,
          const dealii::Tensor<1, dim>    &gravity);

    dealii::Tensor<1, dim> along; ///< unit vector of the run-out
    dealii::Tensor<1, dim> up;    ///< unit vector against gravity
    double                 start; ///< lowest coordinate of the mesh along [m]
    double                 end;   ///< highest coordinate of the mesh along [m]
    double                 floor; ///< lowest coordinate of the mesh upwards [m]

    dealii::Tensor<1, dim> across; ///< unit vector along the depth; in 2D zero
    double                 left;   ///< lowest coordinate of the mesh across [m]
    double                 right; ///< highest coordinate of the mesh across [m]

    /// Height of @p x above the lowest point of the mesh [m].
    double
    height(const dealii::Point<dim> &x) const
    {
      return up * x - floor;
    }

    /// The directions that can be chosen, as dealii::Patterns::Selection takes
    /// them.
    static std::string
    directions();
  };
} // namespace mpm_granular::Observables

#endif
