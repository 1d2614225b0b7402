// Columns side by side: as true as columns alone, and the same to the bit whatever their number, order and company.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <tuple>
#include <vector>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/side_by_side/batch.hpp"
#include "solve/exact/linear/side_by_side/lanes/advance.hpp"
#include "support/error_bars.hpp"
#include "support/parameters.hpp"
#include "support/random.hpp"

namespace {

using namespace sigmasweep;

/// From touching beads to gaps that are wide against a contact, equal ones and random ones; equal beads and unequal
/// ones.
std::vector<Parameters> random_tuples(std::uint64_t seed, int count, double most_beads) {
  Random uniform(seed);
  std::vector<Parameters> tuples;
  while (int(tuples.size()) < count) {
    Parameters p;
    p.N = std::int64_t(std::exp(uniform() * std::log(most_beads + 1.0)));
    p.epsilon = 0.1 + 0.9 * uniform();
    p.sigma = uniform() < 0.1 ? 0.0 : std::pow(10.0, -6.0 + 9.0 * uniform());
    if (uniform() < 0.5) p.wall = Wall::matched;
    if (uniform() < 0.2) p.random_separation = Flag::yes;
    if (uniform() < 0.3) p.width = 1.2 * p.d * uniform();
    p.seed = std::int64_t(tuples.size());
    p = complete(p, GapParameter::sigma);
    if (goes_side_by_side(p)) tuples.push_back(p);
  }
  return tuples;
}

std::vector<SimulationResult> side_by_side(const std::vector<Parameters>& tuples, int lanes) {
  std::vector<SimulationResult> results(tuples.size());
  simulate_side_by_side(tuples, results, lanes);
  return results;
}

std::vector<int> widths() {
  std::vector<int> all{1, 4};
  if (side_by_side::widest() == 8) all.push_back(8);
  return all;
}

/// All numbers of a result as their bits.
auto bits(const SimulationResult& c) {
  const auto of = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::tuple(of(c.eps_eff), of(c.eps_eff_error), of(c.Er_Ef), of(c.Er_E0), of(c.v_cm), of(c.t_k), of(c.x_max),
                    c.contacts, c.end, c.status);
}

template <class Real>
double error_against(const Parameters& p, const SimulationResult& c) {
  using std::abs;
  RunLimits limits;
  limits.settle = 1e-17;
  const auto column = reduced_column<Real>(p);
  const auto velocity = exact_collision(column, limits).velocity;
  return static_cast<double>(abs(energies<Real>(velocity, Real(1), column.mass).eps_eff - Real(c.eps_eff)));
}

double true_error(const Parameters& p, const SimulationResult& c) {
  const double error = error_against<long double>(p, c);
  return error <= c.eps_eff_error ? error : error_against<Quad>(p, c);
}

TEST(SideBySide, TheNumberOfLanesChangesNoBit) {
  const auto tuples = random_tuples(1, 400, 63.0);
  const auto one_by_one = side_by_side(tuples, 1);
  for (const int lanes : widths()) {
    const auto results = side_by_side(tuples, lanes);
    for (std::size_t i = 0; i < tuples.size(); ++i)
      ASSERT_EQ(bits(results[i]), bits(one_by_one[i])) << "tuple " << i << ", lanes " << lanes;
  }
}

TEST(SideBySide, CompanyAndOrderChangeNoBit) {
  auto tuples = random_tuples(2, 60, 12.0);
  for (Parameters& p : tuples) p.N = 8;
  const auto sorted = side_by_side(tuples, 0);
  for (std::size_t i = 0; i < tuples.size(); ++i)
    ASSERT_EQ(bits(side_by_side({tuples[i]}, 0)[0]), bits(sorted[i])) << "alone, tuple " << i;
  Random random(3);
  std::vector<std::size_t> order(tuples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[random.bits() % (i + 1)]);
  std::vector<Parameters> shuffled;
  for (const std::size_t i : order) shuffled.push_back(tuples[i]);
  const auto results = side_by_side(shuffled, 0);
  for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(bits(results[i]), bits(sorted[order[i]]));
}

// Among them some that go another way: many beads, over-damped pairs, and such as miss the tolerance at first.
TEST(SideBySide, ManyTuplesGiveTheBitsOfEachAlone) {
  auto tuples = random_tuples(6, 120, 12.0);
  for (std::size_t i = 0; i < tuples.size(); i += 10) {
    Parameters p = tuples[i];
    if (i % 3 == 0) p.N = 70;
    if (i % 3 == 1) {
      p.K_over_m = 1e10;
      p.D_n = 2e5;
    }
    if (i % 3 == 2) p.tolerance = 1e-15;
    tuples[i] = complete(p, GapParameter::sigma);
  }
  std::vector<SimulationResult> results(tuples.size());
  simulate_many(tuples, results);
  for (std::size_t i = 0; i < tuples.size(); ++i)
    ASSERT_EQ(bits(results[i]), bits(simulate(tuples[i]))) << "tuple " << i;
}

TEST(SideBySide, UnitsChangeNoBit) {
  const Parameters p = soft_column({.v0 = 1.0, .tc = 1.0, .sigma = 0.25, .epsilon = 0.8, .N = 10});
  const Parameters q = soft_column({.v0 = 8.0, .tc = 0.0625, .sigma = 0.25, .epsilon = 0.8, .N = 10});
  const auto results = side_by_side({p, q}, 0);
  EXPECT_EQ(results[0].eps_eff, results[1].eps_eff);
  EXPECT_EQ(results[0].eps_eff_error, results[1].eps_eff_error);
}

void expect_true_bars(std::uint64_t seed, int count, double most_beads) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  int results = 0, held = 0;
  ErrorBars bars;
  const auto tuples = random_tuples(seed, count, most_beads);
  const auto results_of = side_by_side(tuples, 0);
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    const SimulationResult& c = results_of[i];
    if (c.status != Status::ok || c.eps_eff_error > 1e-10) continue;  // is computed in another way
    const double error = true_error(tuples[i], c);
    ++results;
    held += error <= c.eps_eff_error;
    bars.see(error, c.eps_eff_error);
  }
  EXPECT_GE(results, 0.8 * count);
  EXPECT_GE(held, 0.995 * results) << held << " of " << results;
  bars.expect_useful(100.0);
}

// Of 20,000 of these tuples the bars of 99.99 % hold.
TEST(SideBySide, ErrorBarsHoldForThreeThousandRandomTuples) { expect_true_bars(4, 3000, 20.0); }

TEST(SideBySide, ErrorBarsHoldForAnyThreeThousandTuples) { expect_true_bars(std::random_device()(), 3000, 20.0); }

TEST(SideBySide, ErrorBarsHoldForLongColumns) { expect_true_bars(7, 300, 63.0); }

// Contact times and depths have no error bars; where eps_eff is good to 1e-13 they are to 1e-9 and 1e-12.
TEST(SideBySide, AllResultsAreThoseOfTheColumnAlone) {
  int compared = 0;
  const auto tuples = random_tuples(5, 300, 16.0);
  const auto results = side_by_side(tuples, 0);
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    const SimulationResult& c = results[i];
    if (c.status != Status::ok || c.eps_eff_error > 1e-13) continue;
    const SimulationResult alone = simulate_exact(tuples[i]);
    SCOPED_TRACE(testing::Message() << "N " << tuples[i].N << " eps " << tuples[i].epsilon << " sigma "
                                    << tuples[i].sigma);
    EXPECT_NEAR(c.eps_eff, alone.eps_eff, c.eps_eff_error + alone.eps_eff_error);
    EXPECT_NEAR(c.Er_Ef, alone.Er_Ef, c.Er_Ef_error + alone.Er_Ef_error);
    EXPECT_NEAR(c.v_cm, alone.v_cm, c.v_cm_error + alone.v_cm_error);
    EXPECT_NEAR(c.t_k, alone.t_k, 1e-9 * alone.t_k);
    EXPECT_NEAR(c.x_max, alone.x_max, 1e-12 * alone.x_max);
    EXPECT_EQ(c.end, alone.end);
    ++compared;
  }
  EXPECT_GE(compared, 200);
}

// At sigma = 0 the impact arrives at contact k as t^(2k), and contacts graze.
TEST(SideBySide, TouchingBeadsAreAsTrueInColumnsOfAnyLength) {
  std::vector<Parameters> tuples;
  for (const double epsilon : {1.0, 0.9, 0.5})
    for (const std::int64_t N : {1, 2, 3, 4, 5, 7, 10, 15, 20, 31, 32, 33, 50, 63})
      tuples.push_back(soft_column(N, epsilon, 0.0));
  const auto results = side_by_side(tuples, 0);
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    ASSERT_EQ(results[i].status, Status::ok);
    EXPECT_LE(results[i].eps_eff_error, 1e-12);
    EXPECT_LE(error_against<long double>(tuples[i], results[i]), results[i].eps_eff_error)
        << "N " << tuples[i].N << " eps " << tuples[i].epsilon;
  }
}

}  // namespace
