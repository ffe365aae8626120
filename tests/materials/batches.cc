// update_stress() for runs of any length, order and gaps: every point gets
// exactly what it gets alone, points between the runs are not touched, and the
// point whose volume would be inverted is named.

#include "single_point.h"

#include <random>

using namespace Test;

std::mt19937 generator(5);

double
random_number()
{
  return generator() / 2147483648. - 1.;
}

template <int dim>
Points::PointArrays<dim>
random_points(const unsigned int n_points, const unsigned int n_history)
{
  Points::PointArrays<dim> points;
  points.resize(n_points, n_history);
  for (unsigned int i = 0; i < n_points; ++i)
    {
      points.volume[i] = 2. + random_number();
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        points.stress[c][i] = 2e3 * random_number() - (c < 3 ? 4e3 : 0.);
      points.id[i]   = 1000 + i;
      points.cell[i] = i / 10;
      for (unsigned int d = 0; d < dim; ++d)
        points.position[d][i] = i + .25 * d;
    }
  return points;
}

/// Runs over all points, of the lengths given in turn, every @p gap-th left out.
std::vector<Points::Run>
make_runs(const unsigned int               n_points,
          const std::vector<unsigned int> &lengths,
          const unsigned int               gap)
{
  std::vector<Points::Run> runs;
  unsigned int             begin = 0;
  for (unsigned int r = 0; begin < n_points; ++r)
    {
      const unsigned int end =
        std::min(n_points, begin + lengths[r % lengths.size()]);
      if (r % gap != gap - 1)
        runs.push_back({begin, end});
      begin = end;
    }
  return runs;
}

template <int dim>
void
test(const std::string              &law_name,
     const std::vector<std::string> &entries,
     const std::string              &what,
     const std::vector<Points::Run> &runs)
{
  const auto         law      = make_law<dim>(law_name, entries);
  const unsigned int n_points = 500;
  auto               together = random_points<dim>(n_points, 2);
  law->initialize(together, {0, n_points});
  auto         alone     = together;
  const double time_step = 1e-3;

  std::vector<Tensor<2, dim>> gradients(runs.size());
  for (auto &gradient : gradients)
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        gradient[i][j] = 5. * random_number();

  const double released =
    Materials::update_stress<dim>(*law,
                                  together,
                                  {runs.data(), runs.size()},
                                  {gradients.data(), gradients.size()},
                                  time_step);

  double released_alone = 0.;
  for (unsigned int r = 0; r < runs.size(); ++r)
    for (unsigned int i = runs[r].begin; i < runs[r].end; ++i)
      {
        const Points::Run run{i, i + 1};
        released_alone +=
          Materials::update_stress<dim>(*law,
                                        alone,
                                        make_array_view(&run, &run + 1),
                                        make_array_view(&gradients[r],
                                                        &gradients[r] + 1),
                                        time_step);
      }

  double difference = 0.;
  for (unsigned int i = 0; i < n_points; ++i)
    {
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        difference =
          std::max(difference,
                   std::abs(together.stress[c][i] - alone.stress[c][i]) / 1e4);
      for (const auto &[one, other] :
           {std::make_pair(&together.volume, &alone.volume),
            std::make_pair(&together.history[0], &alone.history[0]),
            std::make_pair(&together.history[1], &alone.history[1])})
        difference = std::max(difference, std::abs((*one)[i] - (*other)[i]));
    }
  std::cout << dim << "D, " << law_name << ", " << what << std::endl;
  // Vectorized and scalar loops differ in round-off, for the fused products.
  compare("  difference", difference, 0., 1e-14, 1.);
  compare("  difference of released energies",
          released - released_alone,
          0.,
          1e-13,
          1. + released_alone);
}

template <int dim>
void
test_inversion()
{
  const auto law    = make_law<dim>(granular);
  auto       points = random_points<dim>(20, 2);
  law->initialize(points, {0, 20});
  const std::vector<Points::Run> runs = {{2, 5}, {5, 9}, {9, 10}};
  std::vector<Tensor<2, dim>>    gradients(3);
  gradients[1][0][0] = -1500.;
  for (const double entry : {-1500., std::nan("")})
    try
      {
        gradients[1][0][0] = entry;
        Materials::update_stress<dim>(
          *law,
          points,
          make_array_view(runs.cbegin(), runs.cend()),
          make_array_view(gradients.cbegin(), gradients.cend()),
          1e-3);
        std::cout << "not noticed" << std::endl;
      }
    catch (const ComputationError &error)
      {
        std::cout << error.what() << std::endl;
      }
}

int
main()
{
  const auto short_runs = make_runs(500, {3, 8, 1, 5, 2}, 1000);
  const auto with_gaps  = make_runs(500, {7, 4, 9}, 3);
  const auto long_runs  = make_runs(500, {200, 1, 64, 63, 129}, 1000);
  auto       backwards  = with_gaps;
  std::reverse(backwards.begin(), backwards.end());
  const auto full_batches = make_runs(500, {8}, 1000);
  auto       with_empty   = short_runs;
  with_empty.insert(with_empty.begin() + 3,
                    100,
                    {with_empty[3].begin, with_empty[3].begin});

  for (const auto &[what, runs] :
       {std::make_pair("short runs", short_runs),
        std::make_pair("runs with gaps", with_gaps),
        std::make_pair("long runs", long_runs),
        std::make_pair("runs backwards", backwards),
        std::make_pair("batches that are full", full_batches),
        std::make_pair("empty runs", with_empty),
        std::make_pair("no runs", std::vector<Points::Run>())})
    {
      test<2>(granular, {}, what, runs);
      test<3>(granular, {"Perzyna exponent=3"}, what, runs);
      test<3>(elastic, {}, what, runs);
    }
  for (const std::string law : {"Drucker-Prager cohesive", "mu(I)"})
    test<2>(law, {}, "long runs", long_runs);
  test<3>("Mohr-Coulomb", {"Cohesion=500"}, "short runs", short_runs);
  test_inversion<2>();
  test_inversion<3>();
}
