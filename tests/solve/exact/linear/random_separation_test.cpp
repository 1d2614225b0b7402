// Columns whose beads are shifted at random against an independent program with random numbers of its own: the
// distributions agree.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"

namespace {

using namespace sigmasweep;

/// N = 10, eps = 0.9, shifts uniform in +- s0/2: mean of eps_eff and its standard error, standard deviation.
struct Reference {
  double sigma, mean, standard_error, deviation;
};
constexpr Reference references[] = {{0.1, 0.930627, 1.5e-5, 0.002105},
                                    {0.3, 0.800619, 5.5e-5, 0.007829},
                                    {1.0, 0.447826, 8.9e-4, 0.017772},
                                    {3.0, 0.346955, 3.2e-5, 0.004588},
                                    {10.0, 0.342408, 1.2e-5, 0.001658}};

class RandomSeparation : public testing::TestWithParam<Reference> {};

TEST_P(RandomSeparation, HasTheReferencesMeanAndScatter) {
  const Reference& reference = GetParam();
  constexpr int seeds = 2000;
  double mean = 0.0, second = 0.0;
  std::vector<double> values;
  for (int seed = 0; seed < seeds; ++seed) {
    Parameters p;
    p.sigma = reference.sigma;
    p.random_separation = Flag::yes;
    p.seed = seed;
    const SimulationResult c = simulate(complete(p, GapParameter::sigma));
    ASSERT_EQ(c.status, Status::ok) << seed;
    values.push_back(c.eps_eff);
    mean += c.eps_eff / seeds;
  }
  double fourth = 0.0;
  for (double value : values) {
    const double square = (value - mean) * (value - mean);
    second += square / (seeds - 1);
    fourth += square * square / seeds;
  }
  const double deviation = std::sqrt(second);
  EXPECT_NEAR(mean, reference.mean, 5.0 * std::hypot(reference.standard_error, deviation / std::sqrt(seeds)));
  // The sample's variance has the variance (m4 - m2^2)/n; the reference's own sample is (deviation/standard_error)^2.
  const double kurtosis_less_one = fourth / (second * second) - 1.0;
  const double reference_seeds = std::pow(reference.deviation / reference.standard_error, 2);
  const double error = 0.5 * deviation * std::sqrt(kurtosis_less_one * (1.0 / seeds + 1.0 / reference_seeds));
  EXPECT_NEAR(deviation, reference.deviation, 5.0 * error);
  std::printf("sigma %g: mean %.6f, reference %.6f; deviation %.6f +- %.6f, reference %.6f\n", reference.sigma, mean,
              reference.mean, deviation, error, reference.deviation);
}

INSTANTIATE_TEST_SUITE_P(Sigma, RandomSeparation, testing::ValuesIn(references));

}  // namespace
