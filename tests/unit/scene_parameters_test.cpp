#include "sigmasweep/scene/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "sigmasweep/scene/names.hpp"

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Complete, FillsInTheOtherGap) {
  Parameters p{.v0 = 0.5, .tc = 1e-5};
  p.s0 = 2e-5;
  EXPECT_DOUBLE_EQ(complete(p, Gap::s0).sigma, 4.0);
  p.sigma = 0.25;
  EXPECT_DOUBLE_EQ(complete(p, Gap::sigma).s0, 1.25e-6);
}

TEST(Complete, LeavesTheGivenGapAlone) {
  Parameters p{.v0 = 0.3, .tc = 7e-6, .s0 = 1.23e-7, .sigma = 99.0};
  EXPECT_EQ(complete(p, Gap::s0).s0, 1.23e-7);
  EXPECT_EQ(complete(p, Gap::sigma).sigma, 99.0);
}

TEST(Complete, NoGapIsSigmaZeroEvenWhereTheUnitOfLengthUnderflows) {
  const Parameters p{.v0 = 1e-200, .tc = 1e-200, .s0 = 0.0, .sigma = 5.0};
  EXPECT_EQ(complete(p, Gap::s0).sigma, 0.0);
  EXPECT_EQ(why_invalid(complete(p, Gap::s0)), "");
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
  double Parameters::* member;
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
    testing::Values(Refusal{"v0", &Parameters::v0, 0.0}, Refusal{"v0", &Parameters::v0, -1.0},
                    Refusal{"v0", &Parameters::v0, infinity}, Refusal{"v0", &Parameters::v0, nan},
                    Refusal{"tc", &Parameters::tc, 0.0}, Refusal{"tc", &Parameters::tc, nan},
                    Refusal{"s0", &Parameters::s0, -1e-9}, Refusal{"s0", &Parameters::s0, nan},
                    Refusal{"sigma", &Parameters::sigma, -1.0}, Refusal{"sigma", &Parameters::sigma, infinity},
                    Refusal{"epsilon", &Parameters::epsilon, 0.0}, Refusal{"epsilon", &Parameters::epsilon, 1.0000001},
                    Refusal{"epsilon", &Parameters::epsilon, nan}, Refusal{"d", &Parameters::d, 0.0},
                    Refusal{"steps_per_tc", &Parameters::steps_per_tc, 1.9},
                    Refusal{"steps_per_tc", &Parameters::steps_per_tc, 1.1e6},
                    Refusal{"steps_per_tc", &Parameters::steps_per_tc, nan},
                    Refusal{"tolerance", &Parameters::tolerance, 0.0},
                    Refusal{"tolerance", &Parameters::tolerance, 0.2},
                    Refusal{"tolerance", &Parameters::tolerance, nan}));

TEST(WhyInvalid, RefusesNumbersOfBeads) {
  for (const std::int64_t N : {std::int64_t{0}, std::int64_t{-3}, std::int64_t{1'000'001}}) {
    Parameters p;
    p.N = N;
    EXPECT_EQ(why_invalid(p).rfind("N = " + std::to_string(N) + " ", 0), 0u) << why_invalid(p);
  }
}

TEST(WhyInvalid, RefusesASigmaThatOverflows) {
  const Parameters p{.v0 = 1e-200, .tc = 1e-200, .s0 = 1.0};
  EXPECT_EQ(why_invalid(complete(p, Gap::s0)).rfind("sigma = inf", 0), 0u);
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
