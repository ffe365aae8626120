#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/observables/frame.h>

#include <tuple>

namespace mpm_granular::Observables
{
  using namespace dealii;

  namespace
  {
    /// The unit vector with the name @p name, say "-x".
    template <int dim>
    Tensor<1, dim>
    axis(const std::string &name)
    {
      const bool     is_negative = !name.empty() && name[0] == '-';
      const char     letter      = name.empty() ? ' ' : name.back();
      Tensor<1, dim> direction;
      require(letter >= 'x' && letter < 'x' + dim &&
                name.size() == (is_negative ? 2u : 1u),
              "There is no direction '" + name + "'; valid names are " +
                Frame<dim>::directions() + ".");
      direction[letter - 'x'] = is_negative ? -1. : 1.;
      return direction;
    }
  } // namespace



  template <int dim>
  Frame<dim>::Frame(const Mesh::BackgroundMesh<dim> &mesh,
                    const std::string               &run_out,
                    const Tensor<1, dim>            &gravity)
    : along(axis<dim>(run_out))
    , up(gravity.norm() > 0. ? -gravity / gravity.norm() :
                               Point<dim>::unit_vector(dim - 1))
  {
    if constexpr (dim == 3)
      {
        across = cross_product_3d(up, along);
        if (across.norm() > 0.)
          across /= across.norm();
      }
    std::tie(start, end)  = mesh.extent(along);
    std::tie(left, right) = mesh.extent(across);
    floor                 = mesh.extent(up).first;
  }



  template <int dim>
  std::string
  Frame<dim>::directions()
  {
    return dim == 2 ? "x|y|-x|-y" : "x|y|z|-x|-y|-z";
  }



  template struct Frame<2>;
  template struct Frame<3>;
} // namespace mpm_granular::Observables
