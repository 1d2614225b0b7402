#include "sigmasweep/model/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "assembly/ground.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/result.hpp"
#include "support/parameters.hpp"

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Complete, FillsInTheOtherGap) {
  Parameters p{.v0 = 0.5, .tc = 1e-5};
  p.s0 = 2e-5;
  EXPECT_DOUBLE_EQ(complete(p, GapParameter::s0).sigma, 4.0);
  p.sigma = 0.25;
  EXPECT_DOUBLE_EQ(complete(p, GapParameter::sigma).s0, 1.25e-6);
}

TEST(Complete, LeavesTheGivenGapAlone) {
  Parameters p{.v0 = 0.3, .tc = 7e-6, .s0 = 1.23e-7, .sigma = 99.0};
  EXPECT_EQ(complete(p, GapParameter::s0).s0, 1.23e-7);
  EXPECT_EQ(complete(p, GapParameter::sigma).sigma, 99.0);
}

TEST(Complete, NoGapIsSigmaZeroEvenWhereTheUnitOfLengthUnderflows) {
  const Parameters p{.v0 = 1e-200, .tc = 1e-200, .s0 = 0.0, .sigma = 5.0};
  EXPECT_EQ(complete(p, GapParameter::s0).sigma, 0.0);
  EXPECT_EQ(why_invalid(complete(p, GapParameter::s0)), "");
}

/// Fig. 5's plate: 1.24 mm at 20 Hz; its acceleration over g worked out elsewhere
TEST(Complete, FillsInThePlate) {
  EXPECT_NEAR(vibrated_column({.A0 = 1.24e-3}).alpha, 1.9960545496188875, 1e-14);  // a few roundings
  EXPECT_NEAR(vibrated_column({.alpha = 4.0}).A0, 2.484902028828334e-3, 1e-15);
  EXPECT_EQ(vibrated_column({.A0 = 1.24e-3}).A0, 1.24e-3);
  EXPECT_EQ(vibrated_column({.alpha = 4.0}).alpha, 4.0);
  EXPECT_NEAR(vibrated_column({.alpha = 3.0, .A0 = 1.24e-3}).alpha, 1.9960545496188875, 1e-14);  // A0 counts
  EXPECT_EQ(complete(Parameters{.alpha = 4.0}, GapParameter::s0).A0, 0.0);                       // no plate
}

TEST(Complete, LeavesACompletePlateAlone) {
  for (int k = 1; k <= 1000; ++k) {
    const Parameters from_alpha = vibrated_column({.alpha = 0.01 * k}), from_A0 = vibrated_column({.A0 = 1.7e-5 * k});
    for (const Parameters& p : {from_alpha, from_A0}) {
      EXPECT_EQ(complete(p, GapParameter::s0).alpha, p.alpha);
      EXPECT_EQ(complete(p, GapParameter::s0).A0, p.A0);
    }
  }
}

TEST(Complete, AVibratedColumnHasNoSigma) {
  Parameters p{.tc = 1e-4, .sigma = 0.5};
  p.geometry = Geometry::vibrated_column;
  p.alpha = 2.0;
  EXPECT_EQ(complete(p, GapParameter::sigma).s0, 0.0);
  EXPECT_EQ(complete(p, GapParameter::sigma).sigma, 0.0);
}

TEST(Complete, CountsTheBeadsOfALattice) {
  EXPECT_EQ(lattice({.rows = 10, .columns = 13}).N, 130);
  EXPECT_EQ(lattice({.rows = 1, .columns = 1}).N, 1);
  Parameters p = lattice({.rows = 3, .columns = 5});
  p.geometry = Geometry::vibrated_lattice;
  p.rows = 7;
  derive_beads(p);
  EXPECT_EQ(p.N, 35);
  p.geometry = Geometry::column;
  p.N = 4;
  EXPECT_EQ(complete(p, GapParameter::s0).N, 4);
}

TEST(WhyInvalid, LooksAtTheSizeOfLatticesOnly) {
  EXPECT_EQ(why_invalid(lattice({.rows = 1000, .columns = 1000})), "");
  const auto why = [](auto change) {
    Parameters p = lattice({.rows = 10, .columns = 13});
    change(p);
    const std::string message = why_invalid(p);
    p.geometry = Geometry::column;
    EXPECT_EQ(why_invalid(p), "");
    return message.substr(0, message.find(" is not"));
  };
  EXPECT_EQ(why([](Parameters&) {}), "");
  EXPECT_EQ(why([](Parameters& p) { p.side_walls = SideWalls::fixed; }), "");
  EXPECT_EQ(why([](Parameters& p) { p.rows = 0; }), "rows = 0");
  EXPECT_EQ(why([](Parameters& p) { p.columns = -1; }), "columns = -1");
  EXPECT_EQ(why([](Parameters& p) { p.columns = 1'000'001; }), "columns = 1000001");
  EXPECT_EQ(why([](Parameters& p) { p.rows = INT64_MAX; }), "rows = 9223372036854775807");
  EXPECT_EQ(why([](Parameters& p) { p.N = 131; }), "N = 131");
  EXPECT_EQ(why([](Parameters& p) { p.D_t = -1.0; }), "D_t = -1");
  EXPECT_EQ(why([](Parameters& p) { p.D_t = nan; }), "D_t = nan");
  EXPECT_EQ(why([](Parameters& p) { p.D_t = infinity; }), "D_t = inf");
  EXPECT_EQ(why([](Parameters& p) { p.method = Method::ed; }), "method = 'ed'");
  Parameters many = lattice({.rows = 1001, .columns = 1000});
  EXPECT_NE(why_invalid(many).find("1000000 beads are the most"), std::string::npos);
  many.geometry = Geometry::vibrated_lattice;
  EXPECT_NE(why_invalid(many).find("1000000 beads are the most"), std::string::npos);
}

TEST(PlateHeight, IsEquation1AndKeepsThePhase) {
  const Parameters p = vibrated_column({.A0 = 1.24e-3});
  EXPECT_EQ(plate_height(p, 0.0), 0.0);
  EXPECT_NEAR(plate_height(p, 0.0125), 1.24e-3, 1e-17);  // a quarter of a period
  EXPECT_NEAR(plate_height(p, 0.0375), -1.24e-3, 1e-17);
  EXPECT_NEAR(plate_height(p, 5000.0 + 0.0125), 1.24e-3, 1e-12);  // 5000 s are known to 1e-12 s
}

TEST(WhyInvalid, LooksAtThePlateOfVibratedColumnsOnly) {
  EXPECT_EQ(why_invalid(vibrated_column({.alpha = 2.0})), "");
  const auto why = [](auto change) {
    Parameters p = vibrated_column({.alpha = 2.0});
    change(p);
    const std::string message = why_invalid(p);
    p.geometry = Geometry::column;
    EXPECT_EQ(why_invalid(p), "");
    return message.substr(0, message.find(" is not"));
  };
  EXPECT_EQ(why([](Parameters& p) { p.gravity = 0.0; }), "gravity = 0");
  EXPECT_EQ(why([](Parameters& p) { p.gravity = nan; }), "gravity = nan");
  EXPECT_EQ(why([](Parameters& p) { p.frequency = -1.0; }), "frequency = -1");
  EXPECT_EQ(why([](Parameters& p) { p.frequency = infinity; }), "frequency = inf");
  EXPECT_EQ(why([](Parameters& p) { p.alpha = 0.0; }), "alpha = 0");
  EXPECT_EQ(why([](Parameters& p) { p.alpha = 1.1e6; }), "alpha = 1100000");
  EXPECT_EQ(why([](Parameters& p) { p.A0 = 0.0; }), "A0 = 0");
  EXPECT_EQ(why([](Parameters& p) { p.A0 = nan; }), "A0 = nan");
  EXPECT_EQ(why([](Parameters& p) { p.periods = 0; }), "periods = 0");
  EXPECT_EQ(why([](Parameters& p) { p.periods = 10'000'001; }), "periods = 10000001");
  EXPECT_EQ(why([](Parameters& p) { p.transient = -1; }), "transient = -1");
  EXPECT_EQ(why([](Parameters& p) { p.transient = 120; }), "transient = 120");
  EXPECT_EQ(why([](Parameters& p) { p.transient = 119; }), "");
}

TEST(WhyInvalid, AcceptsTheDefaultsAndTheEndsOfTheRanges) {
  EXPECT_EQ(why_invalid(Parameters{}), "");
  Parameters p;
  p.epsilon = 1.0;
  p.N = 1'000'000;
  p.steps_per_tc = 2.0;
  p.tolerance = 1e-15;
  p.v0 = 1e-300;
  EXPECT_EQ(why_invalid(p), "");
  p.epsilon = 1e-300;
  p.N = 1;
  p.steps_per_tc = 1e6;
  p.tolerance = 0.1;
  p.sigma = 1e300;
  EXPECT_EQ(why_invalid(p), "");
}

struct Refusal {
  const char* name;
  double Parameters::*member;
  double value;
};

class WhyInvalidOf : public testing::TestWithParam<Refusal> {};

TEST_P(WhyInvalidOf, NamesTheParameterAndItsValue) {
  Parameters p;
  p.*GetParam().member = GetParam().value;
  const std::string why = why_invalid(p);
  EXPECT_EQ(why.rfind(std::string(GetParam().name) + " = ", 0), 0u) << why;
  EXPECT_EQ(why.back(), '.');
  EXPECT_EQ(why.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Ranges, WhyInvalidOf,
    testing::Values(
        Refusal{"v0", &Parameters::v0, 0.0}, Refusal{"v0", &Parameters::v0, -1.0},
        Refusal{"v0", &Parameters::v0, infinity}, Refusal{"v0", &Parameters::v0, nan},
        Refusal{"tc", &Parameters::tc, 0.0}, Refusal{"tc", &Parameters::tc, nan}, Refusal{"s0", &Parameters::s0, -1e-9},
        Refusal{"s0", &Parameters::s0, nan}, Refusal{"sigma", &Parameters::sigma, -1.0},
        Refusal{"sigma", &Parameters::sigma, infinity}, Refusal{"epsilon", &Parameters::epsilon, 0.0},
        Refusal{"epsilon", &Parameters::epsilon, 1.0000001}, Refusal{"epsilon", &Parameters::epsilon, nan},
        Refusal{"d", &Parameters::d, 0.0}, Refusal{"steps_per_tc", &Parameters::steps_per_tc, 1.9},
        Refusal{"steps_per_tc", &Parameters::steps_per_tc, 1.1e6},
        Refusal{"steps_per_tc", &Parameters::steps_per_tc, nan}, Refusal{"tolerance", &Parameters::tolerance, 0.0},
        Refusal{"tolerance", &Parameters::tolerance, 0.2}, Refusal{"tolerance", &Parameters::tolerance, nan}));

TEST(WhyInvalid, RefusesNumbersOfBeads) {
  for (const std::int64_t N : {std::int64_t{0}, std::int64_t{-3}, std::int64_t{1'000'001}}) {
    Parameters p;
    p.N = N;
    EXPECT_EQ(why_invalid(p).rfind("N = " + std::to_string(N) + " ", 0), 0u) << why_invalid(p);
  }
}

TEST(WhyInvalid, RefusesASigmaThatOverflows) {
  const Parameters p{.v0 = 1e-200, .tc = 1e-200, .s0 = 1.0};
  EXPECT_EQ(why_invalid(complete(p, GapParameter::s0)).rfind("sigma = inf", 0), 0u);
}

template <class Enum>
void expect_names_round_trip() {
  std::set<std::string_view> seen;
  std::size_t i = 0;
  for (const std::string_view name : names_of<Enum>()) {
    EXPECT_TRUE(seen.insert(name).second) << name;
    EXPECT_EQ(value_named<Enum>(name), static_cast<Enum>(i));
    EXPECT_EQ(name_of(static_cast<Enum>(i++)), name);
  }
  EXPECT_FALSE(value_named<Enum>("").has_value());
  EXPECT_FALSE(value_named<Enum>("MD").has_value());
}

TEST(Names, RoundTrip) {
  expect_names_round_trip<Method>();
  expect_names_round_trip<Geometry>();
  expect_names_round_trip<Wall>();
  expect_names_round_trip<Integrator>();
  expect_names_round_trip<Law>();
  expect_names_round_trip<Material>();
  expect_names_round_trip<EdRule>();
  expect_names_round_trip<Flag>();
  expect_names_round_trip<End>();
  expect_names_round_trip<Status>();
}

TEST(Names, AreThoseOfTheSpecAndTheTable) {
  EXPECT_EQ(name_of(Method::md), "md");
  EXPECT_EQ(name_of(Wall::matched), "matched");
  EXPECT_EQ(name_of(Integrator::gear5), "gear5");
  EXPECT_EQ(name_of(End::settled), "settled");
  EXPECT_EQ(name_of(Status::ok), "ok");
  EXPECT_EQ(name_of(Status::tolerance_missed), "tolerance_missed");
  EXPECT_EQ(name_of(Status::non_finite), "non_finite");
  EXPECT_EQ(name_of(Status::not_run), "not_run");
}

}  // namespace
}  // namespace sigmasweep
