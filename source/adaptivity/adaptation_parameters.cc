#include <mpm_granular/adaptivity/adaptation_parameters.h>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  CriterionSetting<dim>::CriterionSetting()
    : criterion("points")
  {}

  template <int dim>
  void
  CriterionSetting<dim>::add_parameters(ParameterHandler &prm)
  {
    criterion.add_parameters(prm, "Type", "Which cells are to be fine:");
  }

  template <int dim>
  void
  CriterionSetting<dim>::check() const
  {
    criterion->check();
  }

  template <int dim>
  AdaptationParameters<dim>::AdaptationParameters()
    : criteria({})
  {}

  template <int dim>
  void
  AdaptationParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    criteria.add_parameters(
      prm,
      "Criteria for how fine the mesh has to be, each with a subsection of its "
      "name; a cell gets the highest level that any of them wants. Empty: the "
      "mesh stays as it is given.");
    const Patterns::Integer a_level(0, highest_level);
    prm.add_parameter("Minimum level",
                      minimum_level,
                      "How often every cell of the given mesh is divided at "
                      "least. Units: none.",
                      a_level);
    prm.add_parameter("Maximum level",
                      maximum_level,
                      "How often a cell of the given mesh is divided at most; "
                      "each time halves its size. Units: none.",
                      a_level);
    prm.add_parameter("Maximum number of cells",
                      maximum_n_cells,
                      "Cells are not divided where that would make more cells "
                      "than this, first those that would be the finest; a few "
                      "more can be needed between coarse and fine cells. 0 "
                      "stands for any number. Units: none.",
                      Patterns::Integer(0));
    prm.add_parameter("Interval",
                      interval,
                      "Time steps from one adaptation to the next, at most; 0 "
                      "stands for any number. Units: none.",
                      Patterns::Integer(0));
    prm.add_parameter("Interval displacement",
                      interval_displacement,
                      "How far a point may move from one adaptation to the "
                      "next, over the size of the smallest cell; 0 stands for "
                      "any distance. Units: none.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Buffer layers",
      n_buffer_layers,
      "Layers of cells of the same level around those that "
      "want a level, so that points do not leave the fine cells "
      "before the next adaptation. Units: none.",
      Patterns::Integer(0, 100));
    prm.add_parameter("Kept layers",
                      n_kept_layers,
                      "Further layers in which cells are not divided but stay "
                      "if they are fine, so that no cell is divided and undone "
                      "in turn at an edge that moves a little. Units: none.",
                      Patterns::Integer(0, 100));
    prm.add_parameter("Split points below",
                      split_below,
                      "After an adaptation, points are divided in two where a "
                      "cell has points, but fewer than this. 0 stands for "
                      "never. Units: none.",
                      Patterns::Integer(0));
    prm.add_parameter("Merge points above",
                      merge_above,
                      "After an adaptation, points become one with their "
                      "nearest where a cell has more than this. 0 stands for "
                      "never. Units: none.",
                      Patterns::Integer(0));
  }

  template <int dim>
  void
  AdaptationParameters<dim>::check() const
  {
    for (const auto &name : criteria.all_names())
      try
        {
          criteria[name].check();
        }
      catch (const InputError &error)
        {
          throw InputError("Adaptive mesh/" + name + ": " + error.what());
        }
    require(minimum_level <= maximum_level,
            "Adaptive mesh/Minimum level = " + std::to_string(minimum_level) +
              " must not be above 'Maximum level' = " +
              std::to_string(maximum_level) + ".");
    require(criteria.all_names().empty() || interval > 0 ||
              interval_displacement > 0.,
            "Adaptive mesh: 'Interval' and 'Interval displacement' are both 0, "
            "so that the mesh would never be adapted; one of them must be "
            "greater than 0.");
    require(merge_above == 0 || merge_above >= split_below,
            "Adaptive mesh/Merge points above = " +
              std::to_string(merge_above) +
              " must be at least 'Split points below' = " +
              std::to_string(split_below) + ", or 0.");
    if (interval_displacement > 0.)
      require(n_buffer_layers == 0 || interval_displacement <= n_buffer_layers,
              "Adaptive mesh/Interval displacement must be at most 'Buffer "
              "layers' = " +
                std::to_string(n_buffer_layers) +
                ", so that points do not leave the fine cells.");
  }

  template struct CriterionSetting<2>;
  template struct CriterionSetting<3>;
  template struct AdaptationParameters<2>;
  template struct AdaptationParameters<3>;
} // namespace mpm_granular::Adaptivity
