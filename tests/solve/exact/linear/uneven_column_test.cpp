// Columns of unequal beads and unequal gaps: a second method, conservation laws, limits, and the error bar.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "assembly/diameters.hpp"
#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/piecewise_linear.hpp"
#include "support/error_bars.hpp"
#include "support/random.hpp"
#include "support/reference_uneven_columns.hpp"
#include "support/soft_column.hpp"

namespace {

using namespace sigmasweep;

template <class Real>
Column<Real> with_masses(const Parameters& p, const std::vector<double>& mass) {
  Column<Real> column = reduced_column<Real>(p);
  column.mass.assign(mass.begin(), mass.end());
  return column;
}

constexpr std::uint64_t seed = 20250611;

/// Beads of mass 1/4 to 4; every third gap zero, the others up to 2 sigma.
Column<double> random_column(std::int64_t N, double epsilon, double sigma, Random& random) {
  Column<double> column = reduced_column<double>(soft_column(N, epsilon, sigma));
  for (std::int64_t k = 0; k < N; ++k) {
    column.mass.push_back(std::pow(4.0, random(-1.0, 1.0)));
    column.gaps.push_back(random(0.0, 1.0) < 0.33 ? 0.0 : random(0.0, 2.0 * sigma));
  }
  return column;
}

// Both methods are good to about 1e-13; what remains is the reference's stop at rates of 1e-14.
TEST(UnevenColumn, MovesAsTheMatrixExponentialSays) {
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const std::int64_t N = 2 + i % 5;
    const double epsilon = i % 6 == 5 ? random(0.001, 0.1) : random(0.5, 1.0);
    const double sigma = std::pow(10.0, random(-2.0, 1.0));
    const Column<double> column = random_column(N, epsilon, sigma, random);
    const auto expected = piecewise_linear::Solver(column, 0.01).run();
    const auto outcome = exact_collision(column);
    ASSERT_EQ(outcome.status, Status::ok);
    for (std::size_t k = 0; k < column.contacts(); ++k)
      EXPECT_NEAR(outcome.velocity[k], expected.velocity[k], 1e-11)
          << "N " << N << " eps " << epsilon << " sigma " << sigma << " bead " << k;
  }
}

TEST(UnevenColumn, LosesWhatTheDashpotsTake) {
  Random random(seed);
  for (double epsilon : {0.95, 0.6, 0.05}) {
    const Column<double> column = random_column(4, epsilon, 0.3, random);
    const auto expected = piecewise_linear::Solver(column, 0.02, true).run();
    double mass = 0.0;
    for (double m : column.mass) mass += m;
    const double kept = eps_eff(column, exact_collision(column));
    EXPECT_NEAR(1.0 - kept * kept, 2.0 * expected.dashpot_work / mass, 1e-11) << epsilon;
  }
}

TEST(UnevenColumn, SpringsAloneConserveEnergy) {
  Random random(seed);
  for (std::int64_t N : {1, 2, 3, 10, 30, 100})
    for (double sigma : {0.0, 1e-3, 0.3, 3.0, 1e3}) {
      const Column<double> column = random_column(N, 1.0, sigma, random);
      EXPECT_NEAR(eps_eff(column, exact_collision(column)), 1.0, 1e-13) << N << " " << sigma;
    }
}

// The uneven path with masses that are all 1: other roundings, and steps of other lengths.
TEST(UnevenColumn, EqualMassesAreTheUniformColumn) {
  for (std::int64_t N : {1, 2, 5, 10, 20})
    for (double epsilon : {0.99, 0.9, 0.6, 0.01})
      for (double sigma : {0.0, 1e-3, 0.1, 1.0, 3.0}) {
        if (double(N) * (1.0 - epsilon) > 3.0 && sigma > 0.5) continue;  // the last digits decide
        const Parameters p = soft_column(N, epsilon, sigma);
        const auto uniform = reduced_column<double>(p);
        const auto uneven = with_masses<double>(p, std::vector<double>(std::size_t(N), 1.0));
        const auto expected = exact_collision(uniform), outcome = exact_collision(uneven);
        EXPECT_NEAR(eps_eff(uneven, outcome), eps_eff(uniform, expected), 1e-12) << N << " " << epsilon << " " << sigma;
        EXPECT_NEAR(outcome.x_max, expected.x_max, 1e-13);
      }
}

// One heavy or light bead; 64 bits say what is right. (An overdamped heavy bead at the wall creeps for long.)
TEST(UnevenColumn, MassesMayDifferByAMillion) {
  const std::vector<std::vector<double>> cases{{1, 1e-6, 1}, {1e-6, 1, 1}, {1, 1, 1e-6},
                                               {1e6, 1, 1},  {1, 1e6, 1},  {1, 1, 1e6}};
  for (const auto& mass : cases)
    for (double epsilon : {1.0, 0.9, 0.5})
      for (double sigma : {0.0, 5.0}) {
        if (mass[0] > 1.0 && epsilon < 0.9) continue;
        const Parameters p = soft_column(3, epsilon, sigma);
        const auto column = with_masses<double>(p, mass);
        const auto wide = with_masses<long double>(p, mass);
        const auto outcome = exact_collision(column);
        ASSERT_EQ(outcome.status, Status::ok);
        EXPECT_NEAR(eps_eff(column, outcome), eps_eff(wide, exact_collision(wide)), 1e-11)
            << mass[0] << " " << mass[1] << " " << mass[2] << " eps " << epsilon << " sigma " << sigma;
      }
}

// m_ij D_n grows less than the masses do: a heavy pair is overdamped and stays together, two beads of mass M >> 1 as
// one of 2M; with a mean bead's mu and omega0 overdamped means mu > omega0/sqrt(M).
TEST(UnevenColumn, OverdampedBeadsStickTogether) {
  const Parameters p = soft_column(2, 0.05, 0.0);
  const auto column = with_masses<double>(p, {400.0, 400.0});
  const auto outcome = exact_collision(column);
  ASSERT_EQ(outcome.status, Status::ok);
  EXPECT_EQ(outcome.end, End::settled);
  EXPECT_NEAR(outcome.velocity[0], outcome.velocity[1], 1e-11);
  const auto expected = piecewise_linear::Solver(column, 0.05).run();
  EXPECT_NEAR(outcome.velocity[0], expected.velocity[0], 1e-11);
}

// Is the error bar true, in random columns of random beads?
TEST(UnevenColumn, TheErrorBarHolds) {
  Random random(seed);
  ErrorBars bars;
  for (int i = 0; i < 250; ++i) {
    Parameters p = soft_column(std::int64_t(std::exp(random(0.0, std::log(26.0)))), random(0.1, 1.0),
                               random(0.0, 1.0) < 0.1 ? 0.0 : std::pow(10.0, random(-6.0, 4.0)));
    p.seed = i;
    p.width = p.d * (i % 10 == 0 ? 1.9 : random(0.0, 0.5));
    p.random_separation = i % 2 == 0 ? Flag::yes : Flag::no;
    ASSERT_EQ(why_invalid(p), "");
    const SimulationResult c = simulate(p);
    ASSERT_TRUE(c.status == Status::ok || c.status == Status::tolerance_missed) << i << " " << int(c.status);
    if (c.status != Status::ok) continue;  // says of itself that it is no result to 1e-10
    RunLimits limits;
    limits.settle = 1e-17;
    const auto wide = reduced_column<long double>(p);
    const auto outcome = exact_collision(wide, limits);
    double error = double(std::abs(energies<long double>(outcome.velocity, 1.0L, wide.mass).eps_eff - c.eps_eff));
    if (error > c.eps_eff_error) {  // long double may be the one that is off
      const auto widest = reduced_column<Quad>(p);
      const auto last = exact_collision(widest, limits);
      error = double(abs(energies<Quad>(last.velocity, Quad(1), widest.mass).eps_eff - Quad(c.eps_eff)));
    }
    bars.see(error, c.eps_eff_error);
  }
  bars.expect_true(200);
  bars.expect_useful(100.0);
}

// Columns so ill-conditioned that the last digit of a diameter decides the tenth, or fifth, of eps_eff are among them:
// bars are true if all number types start from the same diameters, and derive masses and what follows from them
// themselves.
TEST(UnevenColumn, LiesWithinItsBarOfIndependentResults) {
  for (const reference::UnevenColumn& known : reference::uneven_columns) {
    SCOPED_TRACE(testing::Message() << "seed " << known.seed);
    const Parameters p = soft_column({.v0 = 0.37,
                                      .tc = 3.1e-6,
                                      .sigma = known.sigma,
                                      .epsilon = known.epsilon,
                                      .d = 1e-3,
                                      .width = known.width,
                                      .N = known.N,
                                      .seed = known.seed,
                                      .wall = known.wall,
                                      .random_separation = known.shifted ? Flag::yes : Flag::no});
    ASSERT_EQ(diameters(p).back(), known.highest);
    const SimulationResult c = simulate(p);
    ASSERT_EQ(c.status, Status::ok);
    EXPECT_LE(std::abs(double(known.eps_eff - static_cast<long double>(c.eps_eff))),
              c.eps_eff_error + known.uncertainty);
  }
}

}  // namespace
