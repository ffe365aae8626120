// Layers around what criteria want, the least level, and the largest number of
// cells, on a uniform box and on any number of ranks. A coarse cell counts as
// the 2^l layers of level l that it would be divided into.

#include "state_on_box.h"

using namespace Test;

template <int dim>
void
test(const std::string &cells)
{
  print(std::to_string(dim) + "D, " + cells);
  const unsigned int    n = dim == 2 ? 9 : 7;
  const StateOnBox<dim> box(BoxMesh<dim>(cells, n));

  // The vertices of the central cell, so 3^dim hypercubes.
  const auto middle = [&](const unsigned int level) {
    std::string is_in;
    for (unsigned int d = 0; d < dim; ++d)
      is_in +=
        (d > 0 ? " & " : "") + std::string("(abs(") + "xyz"[d] + "-0.5)<0.1)";
    return std::vector<std::string>{"Names=middle",
                                    "middle/Type=region",
                                    "middle/Level=if(" + is_in + ", " +
                                      std::to_string(level) + ", 0)",
                                    "Interval displacement=0",
                                    "Maximum level=3"};
  };
  const auto adapt = [&](const std::string              &text,
                         std::vector<std::string>        entries,
                         const std::vector<std::string> &more) {
    entries.insert(entries.end(), more.begin(), more.end());
    print(text + box.adapt(entries));
  };

  adapt("no layer", middle(1), {"Buffer layers=0"});
  // 5^dim hypercubes for up to 2 layers of level 1, then 7^dim.
  adapt("1 layer", middle(1), {"Buffer layers=1"});
  adapt("2 layers", middle(1), {"Buffer layers=2"});
  adapt("3 layers", middle(1), {"Buffer layers=3"});
  // The same for up to 8 layers of level 3.
  adapt("8 layers", middle(3), {"Buffer layers=8"});
  adapt("9 layers", middle(3), {"Buffer layers=9"});
  // Kept layers make nothing finer.
  adapt("kept layers", middle(1), {"Kept layers=4"});
  // Layers of level 1 reach farther than those of level 2.
  auto two = middle(2);
  two.insert(two.end(), {"Names=middle, side", "side/Type=region"});
  adapt("two criteria", two, {"side/Level=if(x<0.01, 1, 0)"});
  adapt("at most 1", middle(3), {"Maximum level=1"});
  adapt("at least 1", middle(3), {"Minimum level=1"});

  // Dividing 3^dim hypercubes adds (2^dim - 1) * 3^dim to n^dim.
  const unsigned int per_box = cells == "hypercubes" ? 1 : dim == 2 ? 2 : 5;
  if (per_box == 1)
    {
      const unsigned int most = dim == 2 ? 81 + 3 * 9 : 343 + 7 * 27;
      adapt("just enough",
            middle(2),
            {"Buffer layers=0",
             "Maximum number of cells=" + std::to_string(most)});
      adapt("one too few",
            middle(2),
            {"Buffer layers=0",
             "Maximum number of cells=" + std::to_string(most - 1)});
    }
}

void
refuse(const std::vector<std::string> &entries)
{
  Adaptivity::AdaptationParameters<2> parameters;
  Parameters::read(parameters, "", entries);
  try
    {
      parameters.check();
    }
  catch (const InputError &error)
    {
      print(error.what());
    }
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("hypercubes");
  test<2>("simplices");
  test<3>("hypercubes");
  test<3>("simplices");

  refuse({"Minimum level=3"});
  refuse({"Names=a", "Interval=0", "Interval displacement=0"});
  refuse({"Names=a", "Interval displacement=1.5"});
  refuse({"Names=a", "a/Type=region", "a/Level=1+"});
  const auto is_due = [](const std::vector<std::string> &entries) {
    Adaptivity::AdaptationParameters<2> parameters;
    Parameters::read(parameters, "", entries);
    const Adaptivity::Adaptation<2> adaptation(parameters);
    print(std::string("due") + (adaptation.is_due(99, .49) ? " 1" : " 0") +
          (adaptation.is_due(100, .49) ? " 1" : " 0") +
          (adaptation.is_due(99, .5) ? " 1" : " 0"));
  };
  is_due({});
  is_due({"Names=a"});
  is_due({"Names=a", "Interval=0"});
  is_due({"Names=a", "Interval displacement=0"});
}
