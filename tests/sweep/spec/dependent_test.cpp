// Parameters that are expressions of others, joint samples, and samples of normal distributions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/spec_refusal.hpp"

using namespace sigmasweep;

namespace {

Sweep sweep(const std::string& keys) { return Sweep::parse("[sweep]\n" + keys, "test.toml"); }

std::string refusal(const std::string& keys) { return refusal_of("[sweep]\n" + keys, "test.toml"); }

const std::string column = "v0 = 1\ntc = 1e-5\nN = 10\nepsilon = 0.9\n";

}  // namespace

TEST(Dependent, ParametersFollowOthersInEachTuple) {
  const Sweep all = sweep("v0 = \"2*N\"\ntc = 1e-5\nN = [2, 3]\nepsilon = 0.9\nd = [1e-3, 2e-3]\ns0 = \"0.01*d*v0\"\n");
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all.axes(), (std::vector<std::string>{"N", "d"}));
  for (std::uint64_t row = 0; row < 4; ++row) {
    const Parameters p = all.at(row);
    EXPECT_EQ(p.v0, 2.0 * static_cast<double>(p.N));
    EXPECT_EQ(p.s0, 0.01 * p.d * p.v0);
    EXPECT_EQ(p.sigma, p.s0 / (p.v0 * p.tc));
  }
}

TEST(Dependent, TuplesAreThoseOfPlainNumbers) {
  const std::string rest = "N = 10\nepsilon = 0.9\nlaw = \"hertz\"\nsigma = 1\n";
  const Sweep computed = sweep("v0 = [1, 2]\ntc = \"2*10^-5\"\n" + rest),
              plain = sweep("v0 = [1, 2]\ntc = 2e-5\n" + rest);
  for (const std::uint64_t row : {0U, 1U}) EXPECT_EQ(content_key(computed.at(row)), content_key(plain.at(row)));
}

TEST(Dependent, StiffnessOfALawThatIsNotLinear) {
  const std::string rest = "v0 = 1\nN = [2, 4]\nD_n = 0\nlaw = \"hertz\"\nsigma = 1\n";
  const Sweep computed = sweep("K_over_m = \"1e10*N\"\n" + rest);
  for (const std::uint64_t row : {0U, 1U}) {
    const Sweep plain = sweep("K_over_m = " + std::string(row == 0 ? "2e10" : "4e10") + "\n" + rest);
    EXPECT_EQ(content_key(computed.at(row)), content_key(plain.at(row)));
  }
}

TEST(Dependent, WholeNumbersAndConditions) {
  const Sweep all = sweep("v0 = 1\ntc = 1e-5\nepsilon = 0.9\nsigma = [0.1, 1]\nN = \"sigma > 0.5 ? 10 : 20\"\n");
  EXPECT_EQ(all.at(0).N, 20);
  EXPECT_EQ(all.at(1).N, 10);
  EXPECT_EQ(refusal("v0 = 1\ntc = 1e-5\nepsilon = 0.9\nsigma = [0.1, 1]\nN = \"10*sigma + 1.5\"\n"),
            "test.toml:6: sweep.N = \"10*sigma + 1.5\": is 2.5 where sigma = 0.1, but it must be a whole number");
}

TEST(Dependent, MistakesAreRefused) {
  EXPECT_EQ(refusal(column + "sigma = \"s0*2\"\n"),
            "test.toml:6: sweep.sigma = \"s0*2\": s0 is not given, and has no default");
  EXPECT_EQ(refusal("v0 = \"1e5*tc\"\ntc = \"v0*1e-5\"\nN = 10\nepsilon = 0.9\nsigma = 1\n"),
            "test.toml:2: sweep.v0 = \"1e5*tc\": a circle: v0 -> tc -> v0");
  EXPECT_NE(refusal(column + "sigma = \"0.1*\"\n").find("test.toml:6: sweep.sigma = \"0.1*\": "), std::string::npos);
  EXPECT_NE(refusal(column + "sigma = \"eps_eff\"\n").find("eps_eff"), std::string::npos);
  EXPECT_NE(refusal(column + "sigma = \"N > 3\"\n").find("test.toml:6: sweep.sigma"), std::string::npos);
  EXPECT_NE(refusal("v0 = [1, -1]\n").find("v0 = -1 is not allowed"), std::string::npos);
  EXPECT_NE(refusal("tc = 1e-5\nN = [1, 2]\nepsilon = \"N - 1\"\nv0 = 1\nsigma = 1\n")
                .find("sweep.epsilon = \"N - 1\": is 0 where N = 1, but it must be"),
            std::string::npos);
  EXPECT_NE(
      refusal("v0 = 1\nlaw = \"hertz\"\nmaterial = \"steel\"\nN = 3\ns0 = \"d\"\n").find("d follows from the material"),
      std::string::npos);
}

TEST(JointSample, OfSobolIsANetInAllItsParameters) {
  const Sweep all = sweep(
      "v0 = 1\ntc = 1e-5\nN = 3\nepsilon = { from = 0.5, to = 0.9 }\n"
      "sigma = { from = 0.01, to = 100, scale = \"log\" }\nsample = { of = [\"epsilon\", \"sigma\"], "
      "count = 64 }\n");
  ASSERT_EQ(all.size(), 64U);
  std::set<std::pair<int, int>> boxes;  // 8 x 8 equal ones, a point in each
  for (std::uint64_t row = 0; row < 64; ++row) {
    const Parameters p = all.at(row);
    boxes.emplace(static_cast<int>(std::floor((p.epsilon - 0.5) / 0.4 * 8 + 1e-9)),
                  static_cast<int>(std::floor((std::log10(p.sigma) + 2) / 4 * 8 + 1e-9)));
  }
  EXPECT_EQ(boxes.size(), 64U);
}

TEST(JointSample, IsThatOfZippedSamples) {
  const std::string rest = "v0 = 1\ntc = 1e-5\nN = 3\n", sobol = ", count = 10, sample = \"sobol\", seed = 3 }\n";
  const Sweep joint = sweep(rest +
                            "epsilon = { from = 0.5, to = 0.9 }\nsigma = { from = 1, to = 2 }\nsample = { method "
                            "= \"sobol\", of = [\"epsilon\", \"sigma\"], count = 10, seed = 3 }\n"),
              zipped = sweep(rest + "epsilon = { from = 0.5, to = 0.9" + sobol + "sigma = { from = 1, to = 2" + sobol +
                             "zip = [[\"epsilon\", \"sigma\"]]\n");
  ASSERT_EQ(joint.size(), 10U);
  for (std::uint64_t row = 0; row < 10; ++row) EXPECT_EQ(content_key(joint.at(row)), content_key(zipped.at(row)));
}

TEST(JointSample, MistakesAreRefused) {
  const std::string rest = "v0 = 1\ntc = 1e-5\nN = 3\nsigma = { from = 1, to = 2 }\n";
  EXPECT_EQ(
      refusal(rest + "epsilon = 0.9\nsample = { of = [\"sigma\", \"epsilon\"], count = 4 }\n"),
      "test.toml:6: sweep.epsilon: sweep.sample samples it: give { from, to, scale }, or { sample = \"normal\", mean, "
      "sd }");
  EXPECT_EQ(refusal(rest + "epsilon = 0.9\nsample = { of = [\"sigma\", \"d\"], count = 4 }\n"),
            "test.toml:7: sweep.sample: 'd' is not a parameter in [sweep]");
  EXPECT_NE(refusal(rest + "epsilon = { from = 0.1, to = 0.9, count = 3 }\nsample = { of = [\"sigma\", \"epsilon\"], "
                           "count = 4 }\n")
                .find("test.toml:6: sweep.epsilon.count: is given by sweep.sample"),
            std::string::npos);
}

TEST(NormalSample, HasItsMeanAndStandardDeviation) {
  const Sweep all = sweep(
      "v0 = 1\ntc = 1e-5\nN = 3\nsigma = 1\nepsilon = { sample = \"normal\", mean = 0.8, sd = 0.02, "
      "count = 4000 }\n");
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t row = 0; row < all.size(); ++row) {
    const double x = all.at(row).epsilon - 0.8;
    sum += x;
    squares += x * x;
  }
  // Four standard errors: sd/sqrt(n), and sd^2 sqrt(2/n).
  EXPECT_NEAR(sum / 4000, 0.0, 4 * 0.02 / std::sqrt(4000));
  EXPECT_NEAR(squares / 4000, 4e-4, 4 * 4e-4 * std::sqrt(2.0 / 4000));
}

TEST(NormalSample, OfLogarithmsHasTheMeanOfItsValues) {
  const Sweep all = sweep(
      "v0 = 1\ntc = 1e-5\nN = 3\nepsilon = 0.9\nsigma = { sample = \"log-normal\", mean = 2, sd = 1 }\n"
      "sample = { of = [\"sigma\"], count = 4096 }\n");
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t row = 0; row < all.size(); ++row) {
    sum += all.at(row).sigma;
    squares += all.at(row).sigma * all.at(row).sigma;
  }
  EXPECT_NEAR(sum / 4096, 2.0, 0.01);  // a net of 4096 points integrates well; the tail of the square less so
  EXPECT_NEAR(squares / 4096 - 4.0, 1.0, 0.05);
}

TEST(NormalSample, OfPlainSobolPointsLiesInTheMiddleOfEqualParts) {
  const Sweep all = sweep(
      "v0 = 1\ntc = 1e-5\nN = 3\nsigma = 1\nepsilon = { sample = \"normal\", mean = 0.5, sd = 0.01 }\nsample = { of = "
      "[\"epsilon\"], count = 4 }\n");
  std::vector<double> values;
  for (std::uint64_t row = 0; row < all.size(); ++row) values.push_back((all.at(row).epsilon - 0.5) / 0.01);
  std::ranges::sort(values);
  // The quantiles of 1/8, 3/8, 5/8 and 7/8.
  const std::vector<double> expected{-1.15034938, -0.31863936, 0.31863936, 1.15034938};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(values[k], expected[k], 1e-7) << k;
}

TEST(NormalSample, IsCutOffAtItsEnds) {
  const Sweep all = sweep(
      "v0 = 1\ntc = 1e-5\nN = 3\nsigma = 1\nepsilon = { sample = \"normal\", mean = 0.95, sd = 0.1, "
      "from = 0.5, to = 1, count = 1000 }\n");
  std::vector<double> values;
  for (std::uint64_t row = 0; row < all.size(); ++row) values.push_back(all.at(row).epsilon);
  EXPECT_LE(*std::ranges::max_element(values), 1.0);
  EXPECT_GE(*std::ranges::min_element(values), 0.5);
  std::ranges::sort(values);
  // The median of the normal distribution between Phi(-4.5) and Phi(0.5) = 0.691462: at Phi^-1(0.345733) = -0.396757.
  EXPECT_NEAR(values[500], 0.95 - 0.0396757, 0.02);
  EXPECT_NE(
      refusal("v0 = 1\ntc = 1e-5\nN = 3\nsigma = 1\nepsilon = { sample = \"normal\", mean = 0.95, sd = 0.1, count "
              "= 1000 }\n")
          .find("cut it off by 'from' and 'to'"),
      std::string::npos);
}
