#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assembly/lattice.hpp"
#include "sigmasweep/model/names.hpp"
#include "solve/fixed_step/column/vibrated.hpp"
#include "solve/fixed_step/lattice/vibrated.hpp"
#include "solve/observer/lattice_statistics.hpp"
#include "solve/observer/samples.hpp"
#include "solve/observer/vibration_statistics.hpp"
#include "support/parameters.hpp"

/// Lattices in a container that vibrates, by the methods of fixed step.
namespace sigmasweep {
namespace {

constexpr std::array schemes{Integrator::gear5, Integrator::verlet, Integrator::rk4, Integrator::leapfrog};
constexpr VibrationUnits units{1.0, 1.0};

/// d in units of v0 tc. Neither v0 nor tc counts here; g++ 12 with AVX-512 makes four ones of v0 = tc = 1, s0 = sigma =
/// 0.
Parameters parameters(std::int64_t rows, std::int64_t columns, double epsilon, double d) {
  return vibrated_lattice({.v0 = 0.5,
                           .tc = 2.0,
                           .epsilon = epsilon,
                           .d = d,
                           .periods = 5,
                           .transient = 1,
                           .rows = rows,
                           .columns = columns});
}

/// Of a period of 40 tc, thrice gravity. Beads rest with overlaps of some 0.01.
Plate plate_of(double alpha = 3.0) {
  constexpr double g = 0.02, omega = 2.0 * std::numbers::pi / 40.0;
  return {g, alpha * g / (omega * omega), omega};
}

Vibration run(const Parameters& p, const Lattice<double>& lattice, const Plate& plate, Integrator integrator, double dt,
              LatticeOutcome<double>* outcome = nullptr) {
  LatticeStatistics statistics(p, lattice, plate, units, MotionBetween::steps);
  const auto found = fixed_step_vibrated_lattice(lattice, plate, integrator, dt, statistics);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_EQ(found.end, End::periods);
  if (outcome) *outcome = found;
  return statistics.result();
}

/// Rows of discs much larger than all else are a column with 1.5 K and 1.5 C between beads, of which other tests show
/// that it moves as it should. Rows of unit height sqrt(3)/2 d at rest.
TEST(VibratedLatticeFixedStep, HugeDiscsAreAColumn) {
  constexpr double d = 1e9;
  const Plate plate = plate_of();
  for (const std::int64_t rows : {1, 4})
    for (const Integrator integrator : schemes) {
      SCOPED_TRACE(testing::Message() << name_of(integrator) << " rows " << rows);
      const Parameters p = parameters(rows, 3, 0.7, d);
      const Lattice<double> lattice = reduced_lattice<double>(p);
      Column<double> column = lattice.beads;
      column.N = rows;
      column.K *= 1.5;
      column.C *= 1.5;
      LatticeOutcome<double> outcome;
      const Vibration v = run(p, lattice, plate, integrator, 0.01, &outcome);
      VibrationStatistics statistics(p, column, plate, units, MotionBetween::steps);
      const auto expected = fixed_step_vibrated_column(column, plate, integrator, 0.01, statistics);
      const Vibration w = statistics.result();
      // A few contacts a period, each of which takes rounding, 1e-9 for these diameters, further.
      constexpr double same = 1e-6;
      ASSERT_GT(w.power_in, 0.0);
      EXPECT_NEAR(v.h_cm_excess, w.h_cm_excess, same * w.h_cm_excess);
      EXPECT_NEAR(v.h_cm - v.h_cm_excess, d * (0.5 + 0.5 * double(rows - 1) * std::sqrt(0.75)), 1e-12 * d);
      EXPECT_NEAR(v.E_r, w.E_r, same * w.E_r + 1e-30);
      // Forces and losses are those of a step's last stage, not of its result: predicted rates, in the second case
      // squared, are off by a step where a contact closes, a hundredth of a contact.
      // Those of leapfrog are always half a step late: by omega dt/2 of the dashpot's force, which is at most 2 D/omega
      // = 2 L/pi of the spring's, L = -ln epsilon.
      const double late = integrator == Integrator::leapfrog ? 0.5 * std::numbers::pi * 0.01 : 0.0;
      const double dashpot = 2.0 * -std::log(0.7) / std::numbers::pi;
      EXPECT_NEAR(v.power_in, w.power_in, (1e-5 + late * dashpot) * w.power_in);
      EXPECT_NEAR(v.power_lost, w.power_lost, (3e-3 + late) * w.power_lost);
      EXPECT_LT(std::fabs(v.imbalance), 5e-3);  // of the column 3.4e-3, the most of these
      EXPECT_NEAR(v.h_cm_error, w.h_cm_error, same * w.h_cm_excess);
      EXPECT_GE(outcome.contacts, 3 * expected.contacts);  // a row has three beads, and two contacts for each
    }
}

/// With walls, friction and beads of all sizes: what comes in goes out or stays. First order in the step.
TEST(VibratedLatticeFixedStep, EnergyBalances) {
  for (const Integrator integrator : schemes) {
    SCOPED_TRACE(name_of(integrator));
    Parameters p = parameters(4, 5, 0.8, 100.0);
    p.side_walls = SideWalls::fixed;
    p.width = 10.0;
    p.sigma = 2.0;
    Lattice<double> lattice = reduced_lattice<double>(p);
    lattice.D_t = 0.5 * lattice.beads.C;
    shift_at_random(lattice, 3);
    const double coarse = std::fabs(run(p, lattice, plate_of(), integrator, 0.02).imbalance);
    const double fine = std::fabs(run(p, lattice, plate_of(), integrator, 0.001).imbalance);
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, 3e-4);  // of a step 20 times shorter
  }
}

/// Below alpha = 1 nothing comes off: the lattice moves with the container, and rings a little with the first jerk.
TEST(VibratedLatticeFixedStep, RestsOnASlowPlate) {
  const Parameters p = parameters(3, 4, 0.5, 1000.0);
  const Lattice<double> lattice = reduced_lattice<double>(p);
  Plate plate = plate_of(0.5);
  plate.omega /= 10.0;
  plate.A0 *= 100.0;
  LatticeOutcome<double> outcome;
  const Vibration v = run(p, lattice, plate, Integrator::rk4, 0.01, &outcome);
  EXPECT_EQ(outcome.contacts, 0u);
  // Mean overlaps at rest: the bottom bears 3 g, the rows above 2 g and 1 g on 1.5 K; a row's overlap times (3 - row).
  const double K = lattice.beads.K, g = plate.g, bottom = 3.0 * g / K, first = 2.0 * g / (1.5 * K), top = g / (1.5 * K);
  const double sag = (3.0 * bottom + 2.0 * first + top) / 3.0;
  EXPECT_NEAR(v.h_cm_excess, -sag, 1e-3 * sag);
  EXPECT_NEAR(v.cm_period, plate.period(), 1e-9 * plate.period());
  EXPECT_LT(v.E_r, 1e-9);
}

TEST(VibratedLatticeFixedStep, SamplesOfHugeDiscsAreThoseOfAColumn) {
  const Parameters p = parameters(3, 2, 0.7, 1e9);
  const Lattice<double> lattice = reduced_lattice<double>(p);
  Column<double> column = lattice.beads;
  column.N = p.rows;
  column.K *= 1.5;
  column.C *= 1.5;
  const Plate plate = plate_of();
  const std::vector<double> times{0.0, 0.123 * plate.period(), 0.5 * plate.period(), 2.25 * plate.period()};
  LatticeSamples samples(times, lattice.count());
  VibratedLatticeSamples watcher(samples, plate.period());
  const auto outcome = fixed_step_vibrated_lattice(lattice, plate, Integrator::rk4, 0.01, watcher);
  EXPECT_EQ(outcome.status, Status::ok);
  ASSERT_TRUE(samples.done());
  Samples expected(times, column.contacts());
  VibratedSamples column_watcher(expected, plate.period());
  fixed_step_vibrated_column(column, plate, Integrator::rk4, 0.01, column_watcher);
  for (std::size_t k = 0; k < times.size(); ++k) {
    double z = 0.0, v = 0.0;
    for (std::size_t i = 0; i < lattice.count(); ++i) {
      if (i % 2 == 0) {  // the first of a row; a row's overlap is a column's
        z -= expected.x(k)[i / 2];
        v -= expected.u(k)[i / 2];
      }
      EXPECT_NEAR(samples.q(k)[i].z, z, 1e-6) << k << " " << i;  // 1e-9 grows in a few contacts
      EXPECT_NEAR(samples.v(k)[i].z, v, 1e-6) << k << " " << i;
      EXPECT_NEAR(samples.q(k)[i].x, 0.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace sigmasweep
