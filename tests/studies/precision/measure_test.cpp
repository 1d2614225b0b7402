#include "studies/precision/measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "assembly/column.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/contact/calibration.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "solve/fixed_step/column/collision.hpp"
#include "studies/precision/text.hpp"
#include "studies/sections.hpp"
#include "support/soft_column.hpp"

namespace sigmasweep {
namespace {

PrecisionSpec study(Integrator integrator, std::vector<double> settings) {
  PrecisionSpec spec;
  spec.integrators = {integrator};
  (integrator == Integrator::exact ? spec.tolerances : spec.steps_per_tc) = settings;
  spec.repeats = 1;
  spec.checks = 3;
  spec.seconds = 1.0;
  return spec;
}

// One bead at the wall: eps_eff is eps_wall, in closed form. Gear's worst error over random phases of one collision at
// eps = 0.9 was measured with another program for a pair: 3.6e-3 at tc/50, 1.7e-3 at tc/100. At the wall the contact
// takes sqrt(2) times as long, so the order of magnitude is what can be compared.
TEST(Precision, GearOnOneCollision) {
  PrecisionSpec spec = study(Integrator::gear5, {50, 100});
  spec.tuples = 400;
  const auto rows = measure_precision(soft_column(1, 0.9, 1.0), 7, spec);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_GT(rows[0].error_max, 0.9e-3);
  EXPECT_LT(rows[0].error_max, 7.2e-3);
  EXPECT_GT(rows[1].error_max, 0.4e-3);
  EXPECT_LT(rows[1].error_max, 3.4e-3);
  for (const PrecisionRow& row : rows) {
    EXPECT_EQ(row.scene, 7u);
    EXPECT_EQ(row.tuples, 400u);
    EXPECT_EQ(row.compared, 400u);
    EXPECT_EQ(row.failures, 0u);
    EXPECT_EQ(row.independent, 1u);
    EXPECT_EQ(row.checks, 3u);
    EXPECT_EQ(row.chaotic, 0u);
    EXPECT_LT(row.noise, 1e-15);
    EXPECT_LE(row.error_median, row.error_99);
    EXPECT_LE(row.error_99, row.error_max);
    EXPECT_NEAR(row.velocity_max, row.error_max, 1e-15);  // of one bead they are the same
    EXPECT_GT(row.run_time, 0.0);
    EXPECT_GT(row.evaluations, row.setting * std::sqrt(2.0));  // the contact's duration over the step
    EXPECT_LT(row.evaluations, row.setting * std::sqrt(2.0) + 8.0);
  }
}

// The same numbers straight from the solver: at one bead and whatever phases, every error is one of a fine scan's.
TEST(Precision, IsWhatADirectComputationGives) {
  PrecisionSpec spec = study(Integrator::verlet, {40});
  spec.tuples = 200;
  const auto rows = measure_precision(soft_column(1, 0.6, 2.0), 0, spec);
  const double truth = wall_restitution(0.6);
  double least = 1.0, most = 0.0;
  for (int k = 0; k < 4000; ++k) {
    Column<double> column = reduced_column<double>(soft_column(1, 0.6, 2.0));
    column.gap += k / 4000.0 / 40.0;
    const auto outcome = fixed_step_collision(column, Integrator::verlet, 1.0 / 40.0);
    const double error = std::fabs(outcome.velocity[0] - truth);
    least = std::min(least, error);
    most = std::max(most, error);
  }
  EXPECT_LE(rows[0].error_max, most * 1.001);
  EXPECT_GE(rows[0].error_max, most * 0.95);
  EXPECT_GE(rows[0].error_median, least);
}

TEST(Precision, ExactIsExact) {
  PrecisionSpec spec = study(Integrator::exact, {1e-3, 1e-13});
  spec.tuples = 20;
  for (const PrecisionRow& row : measure_precision(soft_column(10, 0.9, 0.3), 0, spec)) {
    EXPECT_EQ(row.failures, 0u);
    EXPECT_EQ(row.compared, 20u);
    EXPECT_LE(row.error_max, std::max(row.setting, 1e-15));
    EXPECT_TRUE(std::isnan(row.evaluations));
  }
}

// Without a gap there is one tuple for exact and one reference; the phases of the steps differ all the same.
TEST(Precision, NoGap) {
  PrecisionSpec spec = study(Integrator::rk4, {50});
  spec.tuples = 30;
  const PrecisionRow row = measure_precision(soft_column(3, 0.9, 0.0), 0, spec)[0];
  EXPECT_EQ(row.tuples, 30u);
  EXPECT_EQ(row.compared, 30u);
  EXPECT_EQ(row.references, 1u);
  EXPECT_LT(row.error_median, row.error_max);
}

// Two steps a contact are too few: velocity Verlet is unstable there. It is counted, and not compared.
TEST(Precision, FailuresAreCounted) {
  PrecisionSpec spec = study(Integrator::verlet, {2});
  spec.tuples = 10;
  const PrecisionRow row = measure_precision(soft_column(5, 0.1, 0.3), 0, spec)[0];
  EXPECT_GT(row.failures, 0u);
  EXPECT_EQ(row.failures + row.compared, 10u);
  EXPECT_NE(precision_text(std::span(&row, 1), {}).find(std::to_string(row.failures)), std::string::npos);
}

TEST(Precision, OtherLawsHaveOneMethodTwice) {
  PrecisionSpec spec = study(Integrator::verlet, {100});
  spec.tuples = 3;
  Parameters p = soft_column(2, 0.9, 0.3);
  p.law = Law::hertz;
  const PrecisionRow row = measure_precision(p, 0, spec)[0];
  EXPECT_EQ(row.independent, 0u);
  EXPECT_LT(row.noise, 1e-11);
  EXPECT_LT(row.error_max, 1e-2);
  EXPECT_GT(row.error_max, 1e-8);
  EXPECT_NE(precision_text(std::span(&row, 1), {}).find("less independent"), std::string::npos);
}

TEST(Precision, TooLongIsLeftOut) {
  PrecisionSpec spec = study(Integrator::verlet, {100, 1e9});
  spec.tuples = 2;
  const auto rows = measure_precision(soft_column(2, 0.9, 0.3), 0, spec);
  EXPECT_EQ(rows[0].tuples, 2u);
  EXPECT_EQ(rows[1].tuples, 0u);
  EXPECT_TRUE(std::isnan(rows[1].error_max));
}

TEST(Precision, SpecIsRead) {
  const std::string sweep = "[sweep]\nv0 = 1\ntc = 1e-5\nN = [1, 2]\nepsilon = 0.9\nsigma = 1\n";
  EXPECT_FALSE(precision_of(Sweep::parse(sweep, "s", study_sections)));
  const std::string table = "[precision]\nintegrators = ['rk4']\nsteps_per_tc = [50]\ntuples = 3\n";
  const auto read = precision_of(Sweep::parse(sweep + table, "s", study_sections));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->integrators, std::vector{Integrator::rk4});
  EXPECT_EQ(read->steps_per_tc, std::vector{50.0});
  EXPECT_EQ(read->tuples, 3u);
  for (const char* wrong : {"integrators = ['rk5']", "integrators = ['rk4', 'rk4']", "steps_per_tc = []", "tuples = 0",
                            "tolerances = [2.0]", "seconds = 0", "tupels = 3"})
    EXPECT_THROW(Sweep::parse(sweep + "[precision]\n" + wrong + "\n", "s", study_sections), SpecError) << wrong;
}

}  // namespace
}  // namespace sigmasweep
