// Energy goes into the dashpots, momentum comes from the wall, and neither is made on the way: to rounding, whatever
// the damping, the law, the masses, the springs and the gaps.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/books.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

Parameters tuple(std::int64_t N, double epsilon, double sigma, Law law = Law::hooke) {
  return soft_column({.sigma = sigma, .epsilon = epsilon, .N = N, .law = law});
}

void watch(const Column<double>& column, Samples& samples) {
  column.exponents.linear() ? observe_exact(column, samples) : observe_nonlinear(column, samples);
}

constexpr double roundings = 1e-12;

/// The energy at the start is half the column's mass, the momentum all of it. `tolerance`, a fraction of these: what an
/// interval's quadrature (1e-15) and the state's rounding sum up to; of laws that are not linear the solver's own
/// accuracy.
void expect_balance(const Column<double>& column, double duration, double tolerance, double per_tc = 50.0) {
  const auto books = books::of(column, duration, std::size_t(duration * per_tc), watch);
  double mass = 0.0;
  for (std::size_t i = 0; i < column.contacts(); ++i) mass += column.mass.empty() ? 1.0 : column.mass[i];
  EXPECT_NEAR(books.energy[0], 0.5 * mass, 1e-15 * mass);
  EXPECT_LE(books.energy_imbalance(), tolerance * mass);
  EXPECT_LE(books.momentum_imbalance(), tolerance * mass);
  EXPECT_LE(books.largest_rise_of_energy(), tolerance * mass);
}

TEST(Balance, OfEveryRestitutionNumberAndGap) {
  for (const double epsilon : {1.0, 1.0 - 1e-12, 0.5, 0.1, 1e-3, 1e-6})
    for (const std::int64_t N : {1, 2, 3, 10})
      for (const double sigma : {0.0, 1e-300, 1e-16, 0.3, 2.0}) {
        SCOPED_TRACE(testing::Message() << "N " << N << " eps " << epsilon << " sigma " << sigma);
        expect_balance(reduced_column<double>(tuple(N, epsilon, sigma)), 12.0 + 4.0 * sigma, roundings);
      }
}

// x'' + 2 D_n x' + K_over_m x = 0. Mode q of N closed contacts at the wall has lambda = 2 - 2 cos((2q-1) pi/(2N+1))
// times a bead's spring and dashpot; its damping is critical at D_n^2 = 2 K_over_m/lambda.
TEST(Balance, OfColumnsWithOneModeCriticallyDamped) {
  for (const std::int64_t N : {1, 2, 3, 10})
    for (std::int64_t q = 1; q <= N; ++q)
      for (const double off : {-1e-6, -1e-12, 0.0, 1e-12, 1e-6}) {
        const double lambda = 2.0 - 2.0 * std::cos(double(2 * q - 1) * std::numbers::pi / double(2 * N + 1));
        Parameters p{.sigma = N % 2 == 0 ? 0.0 : 0.2, .K_over_m = 1e10, .N = N};
        p.D_n = std::sqrt(2.0 * p.K_over_m / lambda) * (1.0 + off);
        SCOPED_TRACE(testing::Message() << "N " << N << " mode " << q << " off by " << off);
        expect_balance(reduced_column<double>(completed(p)), 6.0, roundings);
      }
}

TEST(Balance, OfOverdampedPairs) {
  for (const double damping : {1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.5, 5.0, 20.0})
    for (const std::int64_t N : {1, 2, 3, 10}) {
      Parameters p{.sigma = 0.1, .K_over_m = 1e10, .D_n = damping * 1e5, .N = N};
      SCOPED_TRACE(testing::Message() << "N " << N << " damping " << damping);
      expect_balance(reduced_column<double>(completed(p)), 6.0, roundings);
    }
}

// A light bead among others has 1/sqrt(m) times the frequencies; a heavy one feels next to nothing for long.
TEST(Balance, OfMassesThatDifferByAMillion) {
  const std::vector<std::vector<double>> cases{
      {1, 1e-6, 1}, {1e-6, 1, 1}, {1, 1, 1e-6}, {1e6, 1, 1}, {1, 1e6, 1}, {1, 1, 1e6}, {1e-3, 1e3, 1, 1e-3, 1e3}};
  for (const auto& mass : cases)
    for (const double epsilon : {1.0, 0.9, 0.5, 0.1})
      for (const double sigma : {0.0, 0.3}) {
        Column<double> column = reduced_column<double>(tuple(std::int64_t(mass.size()), epsilon, sigma));
        column.mass = mass;
        SCOPED_TRACE(testing::Message() << mass[0] << " " << mass[1] << " " << mass[2] << " eps " << epsilon
                                        << " sigma " << sigma);
        expect_balance(column, 8.0, roundings, 2000.0);
      }
}

// The wall's spring, the dashpot so that its damping ratio stays: contacts 1e4 times shorter or longer than a pair's.
TEST(Balance, OfWallsOfAnyStiffness) {
  for (const double ratio : {1e-8, 1e-4, 1e4, 1e8})
    for (const std::int64_t N : {1, 2, 3})
      for (const double epsilon : {1.0, 0.5}) {
        Column<double> column = reduced_column<double>(tuple(N, epsilon, 0.1));
        column.K_wall = column.K * ratio;
        column.C_wall = column.C * std::sqrt(ratio);
        SCOPED_TRACE(testing::Message() << "ratio " << ratio << " N " << N << " eps " << epsilon);
        expect_balance(column, 3.0, roundings, 50.0 * std::max(1.0, std::sqrt(ratio)));
      }
}

TEST(Balance, OfMixedGaps) {
  for (const double epsilon : {1.0, 0.5, 1e-3}) {
    Column<double> column = reduced_column<double>(tuple(6, epsilon, 0.2));
    column.gaps = {0.0, 1e-300, 0.2, 1e-16, 0.0, 1.5};
    SCOPED_TRACE(epsilon);
    expect_balance(column, 15.0, roundings);
  }
}

// Local errors of a step are 1e-12, of some hundred steps in all.
TEST(Balance, OfLawsThatAreNotLinear) {
  for (const Law law : {Law::hertz, Law::hertz_kuwabara_kono, Law::taguchi, Law::power, Law::cone})
    for (const double epsilon : {1.0, 1.0 - 1e-12, 0.5, 0.1})
      for (const std::int64_t N : {1, 2, 3, 10})
        for (const double sigma : {0.0, 1e-16, 0.3}) {
          Parameters p = tuple(N, epsilon, sigma, law);
          if (law == Law::power) p.beta = 1.5, p.gamma = 0.75;
          if (!why_invalid(p).empty()) continue;
          SCOPED_TRACE(testing::Message()
                       << "law " << int(law) << " N " << N << " eps " << epsilon << " sigma " << sigma);
          expect_balance(reduced_column<double>(p), 6.0, 1e-10);
        }
}

// What is left of the energy in the end, as simulate() reports it, is what the dashpots did not take.
TEST(Balance, IsWhatEpsEffSays) {
  for (const double epsilon : {1.0, 0.9, 0.5, 0.1, 1e-3})
    for (const std::int64_t N : {1, 2, 3, 10})
      for (const double sigma : {0.0, 0.3}) {  // with wider gaps some contacts come very late
        const Parameters p = tuple(N, epsilon, sigma);
        const SimulationResult c = simulate(p);
        ASSERT_EQ(c.status, Status::ok);
        const double duration = 40.0 * (1.0 + sigma);  // the settled tail included
        const auto books = books::of(reduced_column<double>(p), duration, std::size_t(30.0 * duration), watch);
        const double kept = 1.0 - 2.0 * books.dashpot_work.back() / double(N);
        SCOPED_TRACE(testing::Message() << "N " << N << " eps " << epsilon << " sigma " << sigma);
        EXPECT_NEAR(c.eps_eff * c.eps_eff, kept, 2.0 * c.eps_eff_error + roundings);
        // What is left to lose where simulate() stops, 1e-13, are velocities of its root.
        EXPECT_NEAR(c.v_cm + 1.0, books.wall_impulse.back() / double(N), 1e-6);
      }
}

// Hard spheres: energy never rises, and the wall only pushes. Light beads between heavy ones rattle for thousands of
// collisions, hence few of them.
TEST(Balance, OfHardSpheres) {
  const auto hard = [](const Column<double>& column, Samples& samples) {
    observe_hard_spheres(column, EdRule::lrv, samples);
  };
  for (const double epsilon : {1.0, 0.9, 0.5, 1e-3})
    for (const std::int64_t N : {1, 2, 3, 10, 100})
      for (const double width : {0.0, 1e-3}) {
        if (width > 0.0 && N > 10) continue;
        Parameters p = tuple(N, epsilon, 1.0);
        p.method = Method::ed;
        p.width = width;
        const auto books = books::of(reduced_column<double>(p), 3.0 * double(N), 500, hard);
        SCOPED_TRACE(testing::Message() << "N " << N << " eps " << epsilon << " width " << width);
        double fall = 0.0;
        for (std::size_t j = 1; j < books.momentum.size(); ++j)
          fall = std::max(fall, books.momentum[j - 1] - books.momentum[j]);
        EXPECT_LE(fall, roundings * double(N));
        EXPECT_LE(books.largest_rise_of_energy(), roundings * double(N));
        if (epsilon == 1.0) {
          EXPECT_NEAR(books.energy.back(), books.energy.front(), roundings * double(N));
        }
      }
}

}  // namespace
