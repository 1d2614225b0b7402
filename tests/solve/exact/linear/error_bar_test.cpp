// Is the error bar true? A random thousand tuples against wider arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/linear/column.hpp"
#include "support/error_bars.hpp"
#include "support/parameters.hpp"
#include "support/random.hpp"

namespace {

using namespace sigmasweep;

template <class Real>
Real eps_eff_in(const Parameters& p) {
  RunLimits limits;
  limits.settle = 1e-17;
  const Column<Real> column = reduced_column<Real>(p);
  return energies<Real>(exact_collision(column, limits).velocity, Real(1), column.mass).eps_eff;
}

double true_error(const Parameters& p, const SimulationResult& c) {
  using std::abs;
  const long double wide = eps_eff_in<long double>(p);
  const double error = static_cast<double>(abs(wide - static_cast<long double>(c.eps_eff)));
  if (error <= c.eps_eff_error) return error;
  // Long double may be the one that is off: some rows have been computed in 113 bits.
  return static_cast<double>(abs(eps_eff_in<Quad>(p) - Quad(c.eps_eff)));
}

TEST(ErrorBar, HoldsForARandomThousand) {
  Random uniform(20240917);
  ErrorBars bars;
  for (int i = 0; i < 1000; ++i) {
    Parameters p;
    p.N = std::int64_t(std::exp(uniform() * std::log(26.0)));
    p.epsilon = 0.1 + 0.9 * uniform();
    p.sigma = uniform() < 0.1 ? 0.0 : std::pow(10.0, -6.0 + 10.0 * uniform());
    p = complete(p, GapParameter::sigma);
    const SimulationResult c = simulate(p);
    ASSERT_TRUE(c.status == Status::ok || c.status == Status::tolerance_missed);
    ASSERT_EQ(c.status == Status::ok, c.eps_eff_error <= p.tolerance);
    if (c.status != Status::ok) continue;  // says of itself that it is no result to 1e-10
    bars.see(true_error(p, c), c.eps_eff_error);
  }
  bars.expect_true(850);
  bars.expect_useful(100.0);
}

// Tolerances for which short series are tried first, and one that takes all digits. The reference is the same tuple at
// 1e-12, with an error bar of its own (HoldsForARandomThousand), and at 1e-13 quadruple precision.
TEST(ErrorBar, HoldsAtEveryTolerance) {
  Random uniform(31);
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-13}) {
    SCOPED_TRACE(tolerance);
    ErrorBars bars;
    for (int i = 0; i < 300; ++i) {
      Parameters p;
      p.N = std::int64_t(std::exp(uniform() * std::log(tolerance < 1e-12 ? 12.0 : 60.0)));
      p.epsilon = 0.1 + 0.9 * uniform();
      p.sigma = uniform() < 0.1 ? 0.0 : std::pow(10.0, -6.0 + 8.0 * uniform());
      if (uniform() < 0.25) p.width = p.d * uniform();
      p.tolerance = tolerance;
      p = complete(p, GapParameter::sigma);
      const SimulationResult c = simulate(p);
      if (c.status != Status::ok) continue;
      Parameters finer = p;
      finer.tolerance = 1e-12;
      const SimulationResult better = simulate(finer);
      if (better.status != Status::ok) continue;
      const double error = tolerance < 1e-12
                               ? true_error(p, c)
                               : std::max(0.0, std::abs(better.eps_eff - c.eps_eff) - better.eps_eff_error);
      bars.see(error, c.eps_eff_error);
      EXPECT_LE(error, tolerance) << "N=" << p.N << " epsilon=" << p.epsilon << " sigma=" << p.sigma;
    }
    bars.expect_true(200);
  }
}

// Wide gaps and strong losses: flights many decades longer than the contacts that they lead to, in which a clock that
// counted all of them would lose the moments of a contact.
TEST(ErrorBar, HoldsForWideGaps) {
  Random uniform(7);
  ErrorBars bars;
  for (int i = 0; i < 250; ++i) {
    Parameters p;
    p.N = 1 + std::int64_t(10.0 * uniform());
    p.epsilon = uniform() < 0.5 ? 1e-3 : std::pow(10.0, -3.0 * uniform());
    p.sigma = std::pow(10.0, 4.0 + 8.0 * uniform());
    p.wall = uniform() < 0.5 ? Wall::matched : Wall::paper;
    p = complete(p, GapParameter::sigma);
    const SimulationResult c = simulate(p);
    if (c.status != Status::ok) continue;
    bars.see(true_error(p, c), c.eps_eff_error);
  }
  bars.expect_true(150);  // the others are chaotic, and say so
}

// A wave that runs up a long column closes gap after gap. If the disturbance of the next gap jumped before it is flown
// to the event, it would grow with each of them: to 1e-5 at N = 50, sigma = 0.1.
TEST(ErrorBar, DoesNotGrowWithTheGapsThatAWaveCloses) {
  for (const std::int64_t N : {50, 100})
    for (const double sigma : {0.02, 0.05, 0.1, 0.2, 0.7}) {
      ExactColumn<double, 2, false> column(reduced_column<double>(soft_column(N, 0.9, sigma)),
                                           RunLimits{.settle = 1e-13});
      column.run();
      EXPECT_LE(column.error(1.0), 1e-12) << "N=" << N << " sigma=" << sigma;
    }
}

// Errors of neighbouring places are draws of one distribution: the largest of six is compared with each bar, as some
// may be small by chance.
TEST(ErrorBar, IsUsefulForLongColumnsAlongTheWholeCurve) {
  for (const std::int64_t N : {50, 100})
    for (const double sigma : {0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 1.5}) {
      SCOPED_TRACE(testing::Message() << "N=" << N << " sigma=" << sigma);
      double largest_error = 0.0, largest_bar = 0.0;
      for (int place = 0; place < 6; ++place) {
        const Parameters p = soft_column(N, 0.9, sigma * (1.0 + 1e-3 * place));
        const SimulationResult c = simulate(p);
        ASSERT_EQ(c.status, Status::ok);
        const double error = std::abs(double(eps_eff_in<long double>(p) - static_cast<long double>(c.eps_eff)));
        EXPECT_LE(error, c.eps_eff_error);
        largest_error = std::max(largest_error, error);
        largest_bar = std::max(largest_bar, c.eps_eff_error);
      }
      EXPECT_LE(largest_bar, 1e3 * largest_error);
    }
}

// Up to gaps of sigma = 10 random columns of 16 beads are not chaotic: what double cannot tell the wider types can.
TEST(ErrorBar, MeetsTheToleranceWhereNothingIsChaotic) {
  Random uniform(17);
  for (int i = 0; i < 100; ++i) {
    Parameters p;
    p.N = 2 + std::int64_t(15.0 * uniform());
    p.epsilon = 0.1 + 0.9 * uniform();
    p.sigma = uniform() < 0.1 ? 0.0 : std::pow(10.0, -3.0 + 4.0 * uniform());
    p = complete(p, GapParameter::sigma);
    const SimulationResult c = simulate(p);
    EXPECT_EQ(c.status, Status::ok) << "N=" << p.N << " epsilon=" << p.epsilon << " sigma=" << p.sigma;
    EXPECT_LE(true_error(p, c), c.eps_eff_error) << "N=" << p.N << " epsilon=" << p.epsilon << " sigma=" << p.sigma;
  }
}

// Long bounce sequences that no double, and some that no type, can follow.
TEST(ErrorBar, SaysSoWhereTheLastDigitsDecide) {
  Parameters p;
  p.N = 33;
  p.epsilon = 0.6;
  p.sigma = 1e4;
  p = complete(p, GapParameter::sigma);
  const SimulationResult c = simulate(p);
  EXPECT_EQ(c.status, Status::tolerance_missed);
  EXPECT_GT(c.eps_eff_error, 1e-4);
}

}  // namespace
