#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/drive/loading.h>

#include <map>

namespace mpm_granular::Drive
{
  using dealii::Tensor;

  namespace
  {
    Tensor<2, 3>
    diagonal(const double x, const double y, const double z)
    {
      Tensor<2, 3> result;
      result[0][0] = x;
      result[1][1] = y;
      result[2][2] = z;
      return result;
    }



    Tensor<2, 3>
    shear()
    {
      Tensor<2, 3> result;
      result[0][1] = 1.;
      return result;
    }



    struct Test
    {
      std::string documentation;
      Loading     loading;
    };

    const std::map<std::string, Test> &
    tests()
    {
      using Keeps = Loading::Keeps;
      const Stress<3> compression{{1., 1., -2., 0., 0., 0.}},
        extension{{-1., -1., 2., 0., 0., 0.}},
        in_shear{{0., 0., 0., 1., 0., 0.}};
      const Tensor<2, 3> nothing, lateral = diagonal(1., 1., 0.),
                                  shorter          = diagonal(0., 0., -1.),
                                  longer           = diagonal(0., 0., 1.);
      static const std::map<std::string, Test> all = {
        {"triaxial compression",
         {"shortened along z at constant lateral stress.",
          {shorter, lateral, Keeps::stress, 0, compression}}},
        {"triaxial extension",
         {"stretched along z at constant lateral stress.",
          {longer, lateral, Keeps::stress, 0, extension}}},
        {"undrained triaxial compression",
         {"shortened along z at constant volume.",
          {shorter, lateral, Keeps::volume, 0, compression}}},
        {"undrained triaxial extension",
         {"stretched along z at constant volume.",
          {longer, lateral, Keeps::volume, 0, extension}}},
        {"plane strain compression",
         {"shortened along z at constant stress along x, without strain along "
          "y.",
          {shorter, diagonal(1., 0., 0.), Keeps::stress, 0, in_shear}}},
        {"oedometer",
         {"shortened along z without lateral strain.",
          {shorter, nothing, Keeps::nothing, 0, compression}}},
        {"isotropic compression",
         {"shortened alike in all directions.",
          {diagonal(-1., -1., -1.), nothing, Keeps::nothing, 0, compression}}},
        {"simple shear",
         {"sheared along x, v_x = rate y, at constant stress yy, without "
          "strain along x and z.",
          {shear(), diagonal(0., 1., 0.), Keeps::stress, 1, in_shear}}},
        {"constant volume shear",
         {"sheared along x, v_x = rate y, without any other strain.",
          {shear(), nothing, Keeps::nothing, 0, in_shear}}}};
      return all;
    }
  } // namespace



  std::string
  test_names()
  {
    std::string names;
    for (const auto &[name, test] : tests())
      names += (names.empty() ? "" : "|") + name;
    return names;
  }



  std::string
  test_documentation()
  {
    std::string text = "What is done to the material:";
    for (const auto &[name, test] : tests())
      text += " '" + name + "': " + test.documentation;
    return text;
  }



  Loading
  loading_of(const std::string &test)
  {
    return tests().at(test).loading;
  }
} // namespace mpm_granular::Drive
