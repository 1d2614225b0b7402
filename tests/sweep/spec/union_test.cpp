// Several [[sweep]] with [defaults].
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/spec_refusal.hpp"
#include "sweep/spec/with_settings.hpp"

using namespace sigmasweep;

namespace {

Sweep parse(const std::string& text) { return Sweep::parse(text, "test.toml"); }

const std::string two_parts = R"([defaults]
N = [2, 3]
v0 = 1
tc = 1e-5
epsilon = 0.9
steps_per_tc = [50, 100]

[[sweep]]
method = "ed"
sigma = 0.5

[[sweep]]
integrator = "verlet"
sigma = [0.1, 1]
N = 5
)";

std::string refusal(const std::string& text) { return refusal_of(text, "test.toml"); }

}  // namespace

TEST(Union, HasTheRowsOfOnePartAfterThoseOfTheOther) {
  const Sweep sweep = parse(two_parts);
  ASSERT_EQ(sweep.size(), 2U + 4U);
  EXPECT_EQ(sweep.parts(), 2U);
  const std::vector<std::int64_t> N{2, 3, 5, 5, 5, 5};
  const std::vector<double> sigma{0.5, 0.5, 0.1, 1, 0.1, 1}, steps{100, 100, 50, 50, 100, 100};
  for (std::size_t row = 0; row < 6; ++row) {
    const Parameters p = sweep.at(row);
    EXPECT_EQ(p.N, N[row]) << row;
    EXPECT_EQ(p.sigma, sigma[row]) << row;
    EXPECT_EQ(p.steps_per_tc, steps[row]) << row;  // hard spheres do not use it: it is no axis there
    EXPECT_EQ(p.method, row < 2 ? Method::ed : Method::md) << row;
  }
}

TEST(Union, OfOnePartIsThatSweep) {
  const std::string keys =
      "v0 = 1\ntc = 1e-5\nN = [2, 3]\nepsilon = [0.8, 0.9]\nsigma = 1\nwhere = \"N*epsilon > 1.7\"\n";
  const Sweep one = parse("[sweep]\n" + keys), united = parse("[[sweep]]\n" + keys);
  ASSERT_EQ(one.size(), united.size());
  for (std::uint64_t row = 0; row < one.size(); ++row) EXPECT_EQ(content_key(one.at(row)), content_key(united.at(row)));
  EXPECT_EQ(one.axes(), united.axes());
}

TEST(Union, HasTheColumnsOfAllPartsAndWhatDiffersBetweenThemAsAxes) {
  const Sweep sweep = parse(two_parts);
  EXPECT_EQ(sweep.axes(), (std::vector<std::string>{"N", "steps_per_tc", "sigma", "method", "integrator"}));
  std::vector<std::string> columns;
  for (const Field& field : sweep.columns()) columns.emplace_back(field.name);
  for (const std::string name : {"method", "integrator", "steps_per_tc", "sigma", "predicted_growth"})
    EXPECT_EQ(std::ranges::count(columns, name), 1) << name;
}

TEST(Union, EachPartHasItsOwnCondition) {
  const Sweep sweep = parse(
      "[defaults]\nv0 = 1\ntc = 1e-5\nepsilon = 0.9\nsigma = 1\nwhere = \"N > 3\"\n"
      "[[sweep]]\nN = [2, 4]\n[[sweep]]\nN = [2, 3]\nwhere = \"N < 3\"\n");
  ASSERT_EQ(sweep.size(), 2U);
  EXPECT_EQ(sweep.at(0).N, 4);
  EXPECT_EQ(sweep.at(1).N, 2);
}

TEST(Union, MistakesNameTheTableAndTheLine) {
  EXPECT_EQ(refusal(two_parts + "[defaults.x]\n").substr(0, 45), "test.toml:16: unknown key defaults.x; known: ");
  EXPECT_EQ(refusal("[defaults]\nN = 0\n[[sweep]]\nv0 = 1\ntc = 1e-5\nepsilon = 0.9\nsigma = 1\n"),
            "test.toml:2: defaults.N = 0 is not allowed: it must be a whole number from 1 to 1000000.");
  const std::string part = "[[sweep]]\nv0 = 1\ntc = 1e-5\nepsilon = 0.9\nsigma = 1\nN = 2\n";
  EXPECT_EQ(refusal("[defaults]\nN = 3\n" + part), "test.toml:2: defaults.N: every [sweep] has its own");
  EXPECT_EQ(refusal("[defaults]\nperiods = 3\n" + part), "test.toml:2: defaults.periods: no tuple uses it");
  EXPECT_EQ(refusal(part + "periods = 3\n").substr(0, 41), "test.toml:7: sweep.periods: no tuple uses");
  EXPECT_EQ(refusal("sweep = []\n").substr(0, 19), "test.toml:1: sweep:");
}

TEST(Union, SettingsDoNotGetLostBesidePoints) {
  const std::string text =
      "[defaults]\nN = 2\ntc = 1e-5\nepsilon = 0.9\nsigma = 1\n[[sweep]]\nv0 = 1\n[[sweep]]\npoints = "
      "\"v0,seed\\n3,1\"\n"
      "random_separation = true\n";
  EXPECT_EQ(refusal(spec::with_settings(text, std::vector<std::string>{"v0=2"})),
            "test.toml:11: sweep.v0: is given by the points in line 9");
  const Sweep other = parse(spec::with_settings(text, std::vector<std::string>{"N=7"}));
  for (std::uint64_t row = 0; row < other.size(); ++row) EXPECT_EQ(other.at(row).N, 7);
}

TEST(Union, SettingsReplaceAKeyWhereverItStands) {
  const auto set = [](const std::string& setting) {
    return parse(spec::with_settings(two_parts, std::vector{setting}));
  };
  const Sweep sigma = set("sigma=7");
  ASSERT_EQ(sigma.size(), 2U + 2U);
  for (std::uint64_t row = 0; row < sigma.size(); ++row) EXPECT_EQ(sigma.at(row).sigma, 7);
  EXPECT_EQ(set("N=[4,6,7]").size(), 3U + 3U * 2U * 2U);
  const Sweep wall = set("wall=matched");
  for (std::uint64_t row = 0; row < wall.size(); ++row) EXPECT_EQ(wall.at(row).wall, Wall::matched);
}
