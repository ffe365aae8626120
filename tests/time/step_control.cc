// Steps: a part of the limit, slow growth, the way of a point, exact landing on
// events, refusal above the limit, collapse.

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/time/step_control.h>

#include <iostream>

using namespace dealii;
using namespace mpm_granular;

Time::StepParameters
parameters(const std::string &entries)
{
  Time::StepParameters result;
  for (unsigned int pass = 0; pass < 2; ++pass)
    {
      ParameterHandler prm;
      result.add_parameters(prm);
      prm.parse_input_from_string(entries, "", true);
    }
  return result;
}

template <class Action>
void
refused(Action &&action)
{
  try
    {
      action();
      std::cout << "accepted" << std::endl;
    }
  catch (const std::exception &error)
    {
      std::cout << error.what() << std::endl;
    }
}

int
main()
{
  const double far = 1e9;
  {
    Time::StepControl control(parameters("set CFL = 0.25"));
    std::cout << "part of the limit "
              << control.next_step({8., 1., 0.}, 0., far)
              << ", of a growing limit "
              << control.next_step({80., 1., 0.}, 2., far) << " "
              << control.next_step({80., 1., 0.}, 4., far)
              << ", with fast points "
              << control.next_step({80., 1., 2.}, 6., far) << std::endl;
  }
  {
    // 40 events at 250 steps each: round-off of the time makes no step more.
    Time::StepControl control(
      parameters("set Type = fixed\nset Fixed step = 2e-4"));
    double       time = 0.;
    unsigned int n    = 0;
    for (unsigned int event = 1; event <= 40; ++event)
      while (time < event * 0.05)
        {
          const double step =
            control.next_step({1., 1., 0.}, time, event * 0.05);
          time = std::abs(event * 0.05 - time - step) < 1e-12 * step ?
                   event * 0.05 :
                   time + step;
          ++n;
        }
    std::cout << "fixed steps to 40 events: " << n << std::endl;
  }
  {
    Time::StepControl control(parameters("set CFL = 1"));
    double            time = 0.;
    unsigned int      n    = 0;
    for (; time < 1.; ++n)
      time += control.next_step({.3, 1., 0.}, time, 1.);
    std::cout << "landed after " << n << " steps: " << (time == 1.)
              << std::endl;
  }
  {
    Time::StepControl control(
      parameters("set Type = fixed\nset Fixed step = 0.1"));
    control.check_stability(.2);
    std::cout << "fixed " << control.next_step({.2, 1., 100.}, 0., far)
              << std::endl;
    refused([&] { control.check_stability(.05); });
  }
  {
    Time::StepControl control(parameters("set Least step = 1e-3"));
    refused([&] { control.next_step({1., 1., 1e6}, 0., far); });
  }
}
