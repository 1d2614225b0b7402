#include "solve/exact/lattice/collision.hpp"
#include "assembly/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/result.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/fixed_step/lattice/collision.hpp"
#include "support/parameters.hpp"

/// Lattices of discs from event to event, against an independent program (an exact reduction to a chain of rows where
/// all columns move alike; Runge-Kutta with steps of tc/400 and DOP853 where they do not).
namespace sigmasweep {
namespace {

Parameters rubbing(Parameters p, double D_t_over_D_n) {
  p.D_t = D_t_over_D_n * -std::log(p.epsilon) / p.tc;
  return p;
}

double eps_eff(const Parameters& p, double accuracy = 1e-12) {
  const auto lattice = reduced_lattice<double>(p);
  const auto outcome = lattice_collision(lattice, accuracy);
  EXPECT_EQ(outcome.status, Status::ok);
  return energies(lattice, outcome.velocity).eps_eff;
}

struct Touching {
  std::int64_t rows;
  double epsilon, D_t, eps_eff, uncertainty;
};
class LatticeInTouch : public testing::TestWithParam<Touching> {};

TEST_P(LatticeInTouch, ReboundsAsTheChainOfRows) {
  const Touching& r = GetParam();
  EXPECT_NEAR(eps_eff(rubbing(lattice_of_discs(r.rows, 13, r.epsilon, 0.0), r.D_t)), r.eps_eff, r.uncertainty);
}
INSTANTIATE_TEST_SUITE_P(
    Reference, LatticeInTouch,
    testing::Values(Touching{2, 0.9, 0.0, 0.9465116423, 2e-10}, Touching{3, 0.9, 0.0, 0.9538920599, 2e-10},
                    Touching{4, 0.9, 0.0, 0.9582167084, 3e-10}, Touching{7, 0.9, 0.0, 0.9648898780, 2e-10},
                    Touching{12, 0.9, 0.0, 0.9700415615, 2e-10}, Touching{20, 0.9, 0.0, 0.9742617995, 2e-10},
                    Touching{3, 0.6, 0.0, 0.8220146701, 4e-10}, Touching{5, 0.6, 0.0, 0.8591143157, 2e-10},
                    Touching{10, 0.6, 0.0, 0.8954025310, 2e-10}, Touching{21, 0.6, 0.0, 0.9236003442, 2e-10},
                    Touching{10, 0.9, 0.5, 0.9649596618, 2e-10}, Touching{10, 0.6, 0.5, 0.8865519233, 2e-10},
                    Touching{10, 0.6, 1.0, 0.8780992677, 2e-10}));

/// Overlaps small beside the beads: contacts of 1.5 K and 1.5 c, and the digits of a gap do not depend on a diameter.
TEST(Lattice, BecomesAChainForHugeBeads) {
  EXPECT_NEAR(eps_eff(lattice_of_discs(3, 13, 0.9, 0.0, 1e9)), 0.953891666632599, 1e-9);  // d: 2e-4 of (1000 v0 tc/d)
  EXPECT_NEAR(eps_eff(lattice_of_discs(10, 3, 0.6, 0.0, 1e9)), 0.895399247719405, 1e-9);
}

/// Periodic images of narrow containers.
TEST(Lattice, IsTheSameInNarrowContainers) {
  const double wide = eps_eff(lattice_of_discs(4, 13, 0.9, 0.0));
  for (const std::int64_t columns : {1, 2, 3})
    EXPECT_NEAR(eps_eff(lattice_of_discs(4, columns, 0.9, 0.0)), wide, 1e-11);
}

/// One row of beads that do not touch one another, and a single bead: eps_wall = exp(-pi L/sqrt(2 pi^2 + L^2)).
TEST(Lattice, OfOneRowReboundsAsABead) {
  const double L = -std::log(0.9), pi = std::numbers::pi, wall = std::exp(-pi * L / std::sqrt(2.0 * pi * pi + L * L));
  // 1e-11, and what rounding leaves of positions of the size sigma.
  const auto error = [](double sigma) { return 1e-11 + 16.0 * std::numeric_limits<double>::epsilon() * sigma; };
  for (const double sigma : {0.0, 1.0, 1e4})
    for (const std::int64_t columns : {1, 5})
      EXPECT_NEAR(eps_eff(lattice_of_discs(1, columns, 0.9, sigma)), wall, error(sigma));
}

struct Shifted {
  double sigma;
  std::uint64_t seed;
  double eps_eff;
};
class ShiftedLattice : public testing::TestWithParam<Shifted> {};

TEST_P(ShiftedLattice, ReboundsAsTheOtherProgramSays) {
  const Shifted& r = GetParam();
  auto lattice = reduced_lattice<double>(lattice_of_discs(10, 13, 0.9, r.sigma));
  shift_at_random(lattice, r.seed);
  const auto outcome = lattice_collision(lattice, 1e-10);
  EXPECT_EQ(outcome.end, End::quiet);
  EXPECT_NEAR(energies(lattice, outcome.velocity).eps_eff, r.eps_eff, 2e-5);  // its uncertainty
}
INSTANTIATE_TEST_SUITE_P(Reference, ShiftedLattice,
                         testing::Values(Shifted{0.1, 1, 0.9087273}, Shifted{0.3, 1, 0.7213143},
                                         Shifted{0.3, 2, 0.7162240}, Shifted{0.3, 3, 0.7220644}));

/// Sideways, where nothing pushes from outside: to rounding in clusters that are moved as a whole (39 beads), to the
/// accuracy where parts are moved beside others whose motions are given (130 and 260).
TEST(Lattice, KeepsItsMomentum) {
  for (const double sigma : {0.1, 0.3})
    for (const std::int64_t rows : {3, 10, 20})
      for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
        auto lattice = reduced_lattice<double>(lattice_of_discs(rows, 13, 0.9, sigma));
        shift_at_random(lattice, 3);
        double sideways = 0.0;
        for (const Vec2<double>& v : lattice_collision(lattice, accuracy).velocity) sideways += v.x;
        EXPECT_NEAR(sideways, 0.0, rows == 3 ? 1e-14 : accuracy) << sigma << " " << rows;
      }
}

struct Mean {
  double sigma, mean, mean_error, scatter;
};
class MeanOfLattices : public testing::TestWithParam<Mean> {};

/// Over seeds; four standard errors of both means.
TEST_P(MeanOfLattices, IsThatOfTheOtherProgram) {
  const Mean& r = GetParam();
  constexpr int seeds = 8;
  double sum = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    Parameters p = lattice_of_discs(10, 13, 0.9, r.sigma);
    p.random_separation = Flag::yes;
    p.seed = seed;
    sum += eps_eff(p, 1e-8);
  }
  EXPECT_NEAR(sum / seeds, r.mean, 4.0 * std::hypot(r.mean_error, r.scatter / std::sqrt(double(seeds))));
}
INSTANTIATE_TEST_SUITE_P(Reference, MeanOfLattices,
                         testing::Values(Mean{0.01, 0.9648919, 6.1e-6, 3.9e-5}, Mean{1.0, 0.5235124, 1.2e-3, 7.357e-3},
                                         Mean{10.0, 0.3841767, 1.5e-3, 9.363e-3},
                                         Mean{100.0, 0.3710555, 1.1e-3, 7.008e-3}));

/// Of a large group an event moves those near it at first: accuracies that differ by three orders say how well.
TEST(Lattice, IsAsExactWhereClustersAreLarge) {
  Parameters p = lattice_of_discs(20, 15, 0.9, 0.2);  // 300 beads, most of which touch at a time
  p.random_separation = Flag::yes;
  const double fine = eps_eff(p, 1e-11);
  EXPECT_NEAR(eps_eff(p, 1e-8), fine, 1e-6);
  EXPECT_NEAR(eps_eff(p, 1e-10), fine, 1e-8);
}

TEST(Lattice, ErrorBarHolds) {
  for (const double sigma : {0.03, 0.5, 2.0})
    for (const std::int64_t seed : {1, 2, 3}) {
      Parameters p = lattice_of_discs(5, 4, 0.8, sigma);
      p.random_separation = Flag::yes;
      p.seed = seed;
      p.tolerance = 1e-5;
      const SimulationResult coarse = simulate(p);
      p.tolerance = 1e-10;
      const SimulationResult fine = simulate(p);
      ASSERT_EQ(coarse.status, Status::ok);
      ASSERT_EQ(fine.status, Status::ok);
      EXPECT_LE(std::fabs(coarse.eps_eff - fine.eps_eff), coarse.eps_eff_error + fine.eps_eff_error);
      EXPECT_LE(coarse.eps_eff_error, 1e-5);
    }
}

/// Discs scatter: runs of different accuracy are different runs, which may have the same eps_eff by chance.
TEST(Lattice, ErrorBarHoldsWhereDiscsScatter) {
  for (const double sigma : {3.0, 10.0})
    for (const std::int64_t seed : {1, 2, 3, 4, 5}) {
      Parameters p = lattice_of_discs(10, 4, 0.9, sigma);
      p.random_separation = Flag::yes;
      p.seed = seed;
      p.tolerance = 0.1;
      const SimulationResult coarse = simulate(p);
      p.tolerance = 2e-5;
      const SimulationResult fine = simulate(p);
      EXPECT_LE(std::fabs(coarse.eps_eff - fine.eps_eff), coarse.eps_eff_error + fine.eps_eff_error);
      EXPECT_LE(coarse.eps_eff_error, 0.1);
    }
}

/// However different the velocities are of what loses nothing.
TEST(Lattice, ErrorBarOfElasticLatticesIsSmall) {
  Parameters p = lattice_of_discs(5, 6, 1.0, 3.0);
  p.random_separation = Flag::yes;
  p.tolerance = 1e-5;
  const SimulationResult c = simulate(p);
  EXPECT_EQ(c.status, Status::ok);
  EXPECT_NEAR(c.eps_eff, 1.0, c.eps_eff_error);
}

/// A wait for a late contact of 21.8, 23.4 and 22.9 tc at three accuracies, 24.3 in truth, where 24.01 are the end.
TEST(Lattice, ErrorBarKnowsWhenTheEndIsUndecided) {
  Parameters p = lattice_of_discs(10, 4, 0.9, 0.30014186017127226);
  p.random_separation = Flag::yes;
  p.seed = 565717851122904304;
  constexpr double truth = 0.715555206783;  // long double, 1e-15 and 1e-17
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    p.tolerance = tolerance;
    const SimulationResult c = simulate(p);
    EXPECT_NEAR(c.eps_eff, truth, c.eps_eff_error + 1e-12) << tolerance;
    EXPECT_LE(c.eps_eff_error, 1e-5) << tolerance;
  }
}

/// In one run there is no wait at all, in the other one there are some.
TEST(Lattice, ErrorBarIsNoneOfTheEndWhereNobodyWaits) {
  Parameters p = lattice_of_discs(10, 13, 0.9, 1e-3, 10.0);
  p.random_separation = Flag::yes;
  p.tolerance = 0.1;
  for (const std::int64_t seed : {1, 2, 3, 4, 5}) {
    p.seed = seed;
    EXPECT_LT(simulate(p).eps_eff_error, 1e-3) << seed;
  }
}

/// The largest overlap and how long contacts last, where clusters are moved in parts (130 beads), against fixed steps,
/// and of beads one by one, which touch the wall for t_wall = pi sqrt(2)/sqrt(omega0^2 - mu^2/2).
TEST(Lattice, KnowsItsOverlapsAndContactTimes) {
  for (const double sigma : {0.03, 0.3}) {
    auto lattice = reduced_lattice<double>(lattice_of_discs(10, 13, 0.9, sigma));
    shift_at_random(lattice, 1);
    const auto steps = fixed_step_lattice_collision(lattice, Integrator::rk4, 1.0 / 400.0);
    EXPECT_NEAR(lattice_collision(lattice, 1e-9).x_max, steps.x_max, 1e-3 * steps.x_max) << sigma;
  }
  const auto row = reduced_lattice<double>(lattice_of_discs(1, 5, 0.9, 1.0));
  const double L = -std::log(0.9), pi = std::numbers::pi,
               t_wall = pi * std::sqrt(2.0) / std::sqrt(pi * pi + L * L / 2.0);
  const auto outcome = lattice_collision(row, 1e-12);
  EXPECT_NEAR(outcome.t_k, t_wall, 1e-9);
  EXPECT_NEAR(outcome.contact_time, 5.0 * t_wall, 1e-8);
}

/// Beads that meet one by one scatter, and coarse runs differ in the order of their contacts.
TEST(Lattice, MeetsEveryTolerance) {
  Parameters p = lattice_of_discs(10, 13, 0.9, 1.0);
  p.random_separation = Flag::yes;
  for (const std::int64_t seed : {2, 6, 7}) {
    p.seed = seed;
    std::vector<SimulationResult> results;
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
      p.tolerance = tolerance;
      results.push_back(simulate(p));
      EXPECT_EQ(results.back().status, Status::ok) << seed << ' ' << tolerance;
      EXPECT_LE(results.back().eps_eff_error, tolerance) << seed;
    }
    for (const SimulationResult& c : results)
      EXPECT_NEAR(c.eps_eff, results.back().eps_eff, c.eps_eff_error + results.back().eps_eff_error) << seed;
  }
}

TEST(Lattice, WithoutDampingKeepsItsEnergy) {
  for (const double sigma : {0.0, 0.3, 10.0}) {
    Parameters p = lattice_of_discs(5, 4, 1.0, sigma);
    p.random_separation = Flag::yes;
    EXPECT_NEAR(eps_eff(p), 1.0, 1e-9) << sigma;  // the local accuracy times some hundred contacts
  }
}

/// After long flights positions have fewer digits, and the error bar says so; too few are refused.
TEST(Lattice, KnowsWhatLongFlightsCost) {
  const double L = -std::log(0.9), pi = std::numbers::pi, wall = std::exp(-pi * L / std::sqrt(2.0 * pi * pi + L * L));
  for (const double sigma : {1e4, 1e6, 1e8}) {
    const SimulationResult c = simulate(lattice_of_discs(1, 3, 0.9, sigma));
    EXPECT_NEAR(c.eps_eff, wall, c.eps_eff_error) << sigma;
    EXPECT_LT(c.eps_eff_error, 1e-6) << sigma;
    EXPECT_EQ(c.contacts, 3U);
  }
  EXPECT_NE(why_invalid(lattice_of_discs(10, 3, 0.9, 1e9)), "");
}

/// Fixed steps, another program for nearly everything: first order in the step.
TEST(Lattice, AgreesWithSmallFixedSteps) {
  for (const Law law : {Law::hooke, Law::hertz}) {
    Parameters p = lattice_of_discs(4, 3, 0.7, 0.4);
    p.law = law;
    p.side_walls = SideWalls::fixed;
    p.width = 0.3 * p.d;
    p.random_separation = Flag::yes;
    p = rubbing(p, 0.5);
    const auto lattice = reduced_lattice<double>(p);
    const auto steps = fixed_step_lattice_collision(lattice, Integrator::rk4, 1.0 / 4000.0);
    EXPECT_EQ(steps.status, Status::ok);
    EXPECT_NEAR(eps_eff(p, 1e-10), energies(lattice, steps.velocity).eps_eff, 2e-5);
  }
}

/// A pair too damped to come apart again: it creeps.
TEST(Lattice, OfOverdampedBeadsEnds) {
  for (const double sigma : {0.0, 0.1, 10.0})
    for (const std::int64_t rows : {1, 3}) {
      Parameters p = lattice_of_discs(rows, 2, 0.5, sigma);
      p.K_over_m = 1e11;
      p.D_n = 1e6;  // sqrt(K_over_m) = 3.2e5
      p = completed(p);
      p.tolerance = 1e-6;
      const SimulationResult c = simulate(p);
      EXPECT_EQ(c.status, Status::ok) << sigma << ' ' << rows;
      EXPECT_LT(c.eps_eff, 1e-2);
      EXPECT_GE(c.t_k, 0.0);
    }
}

class ExtremeLattice : public testing::TestWithParam<Parameters> {};

TEST_P(ExtremeLattice, LosesEnergyAndEnds) {
  Parameters p = GetParam();
  p.tolerance = 1e-6;
  const SimulationResult c = simulate(p);
  EXPECT_TRUE(c.status == Status::ok || c.status == Status::tolerance_missed) << int(c.status);
  EXPECT_GT(c.contacts, 0U);
  EXPECT_GE(c.t_k, 0.0);
  EXPECT_GT(c.eps_eff, 0.0);
  EXPECT_LE(c.eps_eff, 1.0 + c.eps_eff_error);
  EXPECT_LT(c.x_max, 2.0 * p.v0 * p.tc);  // a lattice pushes harder than one bead, not much
}
std::vector<Parameters> extremes() {
  std::vector<Parameters> all;
  for (const double sigma : {0.0, 1e-6, 1.0, 1e4}) {
    Parameters p = lattice_of_discs(4, 4, 0.1, sigma);  // strong losses
    p.random_separation = Flag::yes;
    all.push_back(p);
    p.epsilon = 0.9;
    all.push_back(rubbing(p, 100.0));  // beads stick to each other sideways
    p.width = 0.9 * p.d;               // masses differ by a factor of 18
    all.push_back(p);
    p.side_walls = SideWalls::fixed;
    all.push_back(p);
    all.push_back(lattice_of_discs(1, 1, 0.5, sigma));
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Extremes, ExtremeLattice, testing::ValuesIn(extremes()));

}  // namespace
}  // namespace sigmasweep
