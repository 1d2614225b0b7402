#include "solve/reference/normal_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "assembly/energies.hpp"
#include "solve/reference/damped_modes.hpp"
#include "support/parameters.hpp"
#include "support/reference_values.hpp"

namespace sigmasweep {
namespace {

Column<long double> column(std::int64_t N, double epsilon, double sigma, Wall wall = Wall::paper) {
  Parameters p;
  p.N = N;
  p.epsilon = epsilon;
  p.sigma = sigma;
  p.wall = wall;
  return reduced_column<long double>(completed(p));
}

long double eps_eff(const Column<long double>& column) {
  const auto outcome = normal_modes_collision(column, {.settle = 1e-19});
  EXPECT_EQ(outcome.status, Status::ok);
  return energies<long double>(outcome.velocity, 1.0L).eps_eff;
}

// The references know epsilon as a decimal, we as a double: eps_eff moves by up to N times half its last digit, 1e-16.
TEST(NormalModes, AgreesWithIndependentReferences) {
  int compared = 0;
  for (const reference::Soft& r : reference::soft) {
    if (!r.well_conditioned || r.N > 20 || r.uncertainty > 1e-16) continue;
    ++compared;
    EXPECT_LE(std::fabs(eps_eff(column(r.N, r.epsilon, r.sigma)) - static_cast<long double>(r.eps_eff)), 1e-15L)
        << "N " << r.N << " epsilon " << r.epsilon << " sigma " << r.sigma;
  }
  EXPECT_GE(compared, 40);
}

TEST(NormalModes, CountsContactsAndTimesTheWall) {
  const auto outcome = normal_modes_collision(column(10, 0.9, 1.0));
  EXPECT_EQ(outcome.contacts, 77u);
  EXPECT_EQ(outcome.end, End::separated);
  EXPECT_NEAR(static_cast<double>(outcome.t_k), 16.8238023556731405, 1e-13);  // tests/support/reference_values.hpp
}

// One bead at a matched wall comes back as a pair does, by definition.
TEST(NormalModes, MatchedWall) {
  for (const double epsilon : {0.05, 0.6, 0.99})
    EXPECT_NEAR(static_cast<double>(eps_eff(column(1, epsilon, 0.3, Wall::matched))), epsilon, 1e-16);
}

// The matrix from the equations of motion themselves.
TEST(NormalModes, ShapesAreEigenvectors) {
  ModeTables tables;
  for (const RunKind kind : {RunKind::free, RunKind::at_wall, RunKind::at_matched_wall})
    for (std::size_t c = 1; c <= 12; ++c) {
      const DampedModes& modes = tables.of(kind, c);
      const auto shape = [&](std::size_t m, std::size_t j) { return modes.shape[m * c + j]; };
      for (std::size_t j = 0; j < c; ++j)
        for (std::size_t m = 0; m < c; ++m) {
          const auto force = [&](std::size_t k) {
            return k == 0 && kind == RunKind::at_matched_wall ? 2 * shape(0, j) : shape(k, j);
          };
          const long double own = m == 0 && kind != RunKind::free ? 1 : 2;
          const long double x = own * force(m) - (m > 0 ? force(m - 1) : 0) - (m + 1 < c ? force(m + 1) : 0);
          EXPECT_LE(std::fabs(x - modes.lambda[j] * shape(m, j)), 1e-17L) << c << " " << m << " " << j;
          long double unit = 0;  // analysis undoes shape
          for (std::size_t k = 0; k < c; ++k) unit += modes.analysis[k * c + j] * shape(k, m);
          EXPECT_LE(std::fabs(unit - (m == j ? 1 : 0)), 1e-17L);
        }
    }
}

// Closed solutions from y = 1, v = 0 and y = 0, v = 1 for the three kinds of damping, and around the critical one.
TEST(NormalModes, PropagatorAtAnyDamping) {
  const long double t = 0.7L;
  const Propagator free = propagator(0, 4, t);
  EXPECT_LE(std::fabs(free.yy - std::cos(1.4L)), 1e-18L);
  EXPECT_LE(std::fabs(free.yv - std::sin(1.4L) / 2), 1e-18L);
  const Propagator critical = propagator(2, 4, t);  // y = (1 + 2t) exp(-2t); y = t exp(-2t)
  EXPECT_LE(std::fabs(critical.yy - 2.4L * std::exp(-1.4L)), 1e-18L);
  EXPECT_LE(std::fabs(critical.vv - (1 - 1.4L) * std::exp(-1.4L)), 1e-18L);
  const Propagator over = propagator(2.5L, 4, t);  // roots -1 and -4: y = (4 exp(-t) - exp(-4t))/3
  EXPECT_LE(std::fabs(over.yy - (4 * std::exp(-t) - std::exp(-4 * t)) / 3), 1e-18L);
  EXPECT_LE(std::fabs(over.vy - 4 * (std::exp(-4 * t) - std::exp(-t)) / 3), 1e-18L);
  const Propagator strong = propagator(6.5L, 12, t);  // roots -1 and -12, beyond the series
  EXPECT_LE(std::fabs(strong.yy - (12 * std::exp(-t) - std::exp(-12 * t)) / 11), 1e-18L);
}

TEST(NormalModes, RefusesWhatItCannotDo) {
  auto uneven = column(2, 0.9, 0.1);
  uneven.mass = {1, 1.5L};
  EXPECT_THROW(normal_modes_collision(uneven), std::invalid_argument);
  auto hertz = column(2, 0.9, 0.1);
  hertz.exponents.beta = 0.5;
  EXPECT_THROW(normal_modes_collision(hertz), std::invalid_argument);
}

}  // namespace
}  // namespace sigmasweep
