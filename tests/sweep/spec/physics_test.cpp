#include "sigmasweep/sweep/sweep.hpp"

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "support/spec_refusal.hpp"

// Laws, materials, random columns and rules of hard spheres in a spec: what may be given, and what a tuple then is.

using namespace sigmasweep;

namespace {

Sweep sweep(const std::string& body) { return Sweep::parse("[sweep]\n" + body, "test.toml"); }

std::string refusal(const std::string& body) { return refusal_of("[sweep]\n" + body, "test.toml"); }

/// v0, N and s0 on lines 2 to 4, then `more`.
const std::string basis = "v0 = 0.05\nN = 3\ns0 = 1e-6\n";
Sweep with(const std::string& more) { return sweep(basis + more); }
std::string wrong(const std::string& more) { return refusal(basis + more); }
/// With tc and epsilon too, on lines 5 and 6.
const std::string contact = "tc = 1e-5\nepsilon = 0.9\n";

void expect_same(const Parameters& a, const Parameters& b) { EXPECT_EQ(content_key(a), content_key(b)); }

}  // namespace

TEST(Ways, StiffnessAndDampingAreGivenOnce) {
  const std::string ways = "give tc and epsilon, or K_over_m and D_n, or a material";
  EXPECT_EQ(wrong("tc = 1e-5\nepsilon = 0.9\nK_over_m = 1e9"),
            "test.toml:7: sweep.K_over_m: 'tc' and 'K_over_m' conflict: " + ways);
  EXPECT_EQ(wrong("material = \"steel\"\nepsilon = 0.9"),
            "test.toml:6: sweep.epsilon: 'epsilon' and 'material' conflict: " + ways);
  EXPECT_EQ(wrong("material = \"steel\"\nD_n = 1"), "test.toml:6: sweep.D_n: 'D_n' and 'material' conflict: " + ways);
  EXPECT_EQ(wrong("material = \"steel\"\nd = 1e-3"),
            "test.toml:6: sweep.d: 'd' and 'material' conflict: d is the material's");
  expect_part(wrong("D_n = 1"), "'K_over_m' is missing");
  expect_part(wrong("epsilon = 0.9"), "'tc' is missing");
  expect_part(wrong("tc = 1e-5"), "'epsilon' is missing");
  expect_part(wrong(""), "'tc', 'epsilon' are missing");
  EXPECT_EQ(wrong("material = [\"none\", \"steel\"]"),
            "test.toml:5: sweep.material: 'none' is the default: leave the material out");
  EXPECT_EQ(wrong("K_over_m = [1e9, 0]"), "test.toml:5: sweep.K_over_m: must be > 0");
  expect_part(wrong("K_over_m = -1"), "sweep.K_over_m = -1 is not allowed");
  expect_part(wrong("K_over_m = 1\nD_n = -1"), "sweep.D_n = -1 is not allowed");
}

TEST(Ways, ContactFollowsFromStiffnessAtEachSpeed) {
  const Sweep hertz = with("law = \"hertz\"\nK_over_m = 2e12\nD_n = 1e3");
  // From an independent integration, error 9e-11.
  EXPECT_NEAR(hertz.at(0).epsilon, 0.924199892990, 9e-11);
  EXPECT_DOUBLE_EQ(hertz.at(0).sigma, 1e-6 / (0.05 * hertz.at(0).tc));
  EXPECT_EQ(with("K_over_m = 2e9").at(0).epsilon, 1.0);
  const Parameters steel = sweep("v0 = 1\nN = 1\ns0 = 0\nlaw = \"hertz\"\nmaterial = \"steel\"").at(0);
  EXPECT_NEAR(steel.tc, 4.6e-6, 0.05e-6);  // Sec. III
  EXPECT_EQ(steel.d, 1.5e-3);
}

TEST(Ways, RowsAreWhatCompleteSays) {
  const Sweep all = with(
      "d = 1e-3\nlaw = [\"hooke\", \"hertz\", \"taguchi\", \"power\"]\nbeta = [0.3, 0.4]\n"
      "gamma = 0.1\nK_over_m = [2e9, 2e12]\nD_n = [0, 10]\nmethod = [\"md\", \"ed\"]");
  for (std::uint64_t k = 0; k < all.size(); ++k) {
    Parameters given = all.at(k);
    given.tc = given.epsilon = given.sigma = 0.5;
    expect_same(all.at(k), complete(given, GapParameter::s0));
  }
  const Sweep materials = with("law = [\"hooke\", \"hertz\"]\nmaterial = [\"aluminium\", \"steel\"]");
  for (std::uint64_t k = 0; k < materials.size(); ++k) {
    Parameters given;
    given.v0 = 0.05;
    given.N = 3;
    given.s0 = 1e-6;
    given.law = materials.at(k).law;
    given.material = materials.at(k).material;
    expect_same(materials.at(k), complete(given, GapParameter::s0));
  }
}

TEST(Ways, MoreDifferentPairsThanAreRememberedGiveTheSame) {
  const std::string axis = "{ from = 0.01, to = 1, count = 10001, scale = \"log\" }";
  const Sweep many = sweep("N = 1\ns0 = 0\nlaw = \"hertz\"\nmaterial = \"steel\"\nv0 = " + axis);
  const Sweep one = sweep("N = 1\ns0 = 0\nlaw = \"hertz\"\nmaterial = \"steel\"\nv0 = 0.1");
  expect_same(many.at(5000), one.at(0));
}

TEST(Ways, RememberedPairsTakeNoTime) {
  const Sweep sweep = with(
      "law = \"hertz\"\nmaterial = \"steel\"\nrandom_separation = true\n"
      "seed = { from = 1, to = 100000, count = 100000 }");
  const auto start = std::chrono::steady_clock::now();
  double sum = 0.0;
  for (std::uint64_t k = 0; k < sweep.size(); ++k) sum += sweep.at(k).epsilon;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_GT(sum, 0.0);
  EXPECT_LT(taken.count(), 2.0);  // 0.03 s; it would be 5 minutes
}

TEST(Ways, SeveralThreadsGetTheSame) {
  const Sweep sweep = with("law = [\"hertz\", \"taguchi\"]\nK_over_m = [1e12, 2e12]\nD_n = [0, 1, 2]");
  std::vector<std::uint64_t> keys[2];
  std::vector<std::thread> threads;
  for (auto& mine : keys)
    threads.emplace_back([&mine, &sweep] {
      for (int repeat = 0; repeat < 50; ++repeat)
        for (std::uint64_t k = 0; k < sweep.size(); ++k) mine.push_back(content_key(sweep.at(k)));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(keys[0], keys[1]);
}

TEST(Ways, PairsThatStayTogetherAreForSoftSpheres) {
  EXPECT_EQ(wrong("K_over_m = 2e9\nD_n = 1e6"), "accepted");
  expect_part(wrong("method = \"ed\"\nK_over_m = 2e9\nD_n = 1e6"), "test.toml:6: sweep.K_over_m: with v0 = 0.05");
  expect_part(wrong("method = \"ed\"\nK_over_m = 2e9\nD_n = 1e6"), "too damped to come apart");
  // Only in the middle of the axes, and only with one of the laws.
  expect_part(wrong("method = \"ed\"\nlaw = [\"hertz\", \"hooke\"]\nK_over_m = [2e12, 2e9]\n"
                    "zip = [[\"law\", \"K_over_m\"]]\nD_n = [1, 1e6, 2]"),
              "too damped");
  EXPECT_EQ(wrong("method = \"ed\"\nlaw = [\"hertz\", \"hooke\"]\nK_over_m = [2e12, 2e9]\nD_n = [1e3, 1e4]\n"
                  "zip = [[\"law\", \"K_over_m\", \"D_n\"]]"),
            "accepted");
  // More pairs than are looked at one by one: the extremes tell.
  expect_part(refusal("method = \"ed\"\nN = 1\ns0 = 0\nK_over_m = 2e9\nD_n = { from = 0, to = 1e6, count = 2000 }\n"
                      "v0 = { from = 1, to = 2, count = 2000 }"),
              "too damped");
}

TEST(Ways, GapsMustBeFinite) {
  expect_part(refusal("v0 = 1e-200\nN = 1\ns0 = 1e200\nK_over_m = 1e9"), "sigma = inf is not allowed");
  expect_part(refusal("v0 = 1e-200\nN = 1\ns0 = 1e200\nmaterial = \"steel\""), "sigma = inf is not allowed");
}

TEST(PowerLaw, NeedsItsExponentsAndNothingElseDoes) {
  const std::string power = contact + "law = \"power\"\n";
  EXPECT_EQ(wrong(power + "gamma = 0.5"),
            "test.toml:7: sweep.law: 'beta' is missing: law = 'power' needs beta and gamma");
  expect_part(wrong(power + "beta = 0.5"), "'gamma' is missing: law = 'power'");
  EXPECT_EQ(wrong(power + "beta = 0.5\ngamma = 0"), "accepted");
  EXPECT_EQ(wrong(contact + "law = \"hertz\"\nbeta = 0.5\ngamma = 0"),
            "test.toml:8: sweep.beta: no tuple uses it: it needs law = 'power'\n"
            "test.toml:9: sweep.gamma: no tuple uses it: it needs law = 'power'");
  expect_part(wrong(contact + "gamma = 0"), "sweep.gamma: no tuple uses it: it needs law = 'power'");
  EXPECT_EQ(wrong(contact + "law = [\"hertz\", \"power\"]\nbeta = [0.5, 0.6]\ngamma = 0"), "accepted");
  expect_part(wrong(power + "beta = 4.5\ngamma = 0"), "sweep.beta = 4.5 is not allowed");
  expect_part(wrong(contact + "method = [\"ed\", \"md\"]\nlaw = [\"power\", \"hooke\"]\n"
                              "zip = [[\"method\", \"law\"]]\nbeta = 1\ngamma = 1"),
              "sweep.beta: no tuple uses it");
}

TEST(Law, OfHardSpheresOnlyWhereEpsilonFollowsFromIt) {
  EXPECT_EQ(wrong(contact + "method = \"ed\"\nlaw = \"hertz\""),
            "test.toml:8: sweep.law: no tuple uses it: it needs method = 'md', or K_over_m or a material instead of "
            "epsilon");
  EXPECT_EQ(wrong("method = \"ed\"\nlaw = \"hertz\"\nK_over_m = 2e12"), "accepted");
  EXPECT_EQ(wrong("method = \"ed\"\nlaw = \"hertz\"\nmaterial = \"steel\""), "accepted");
  EXPECT_EQ(wrong(contact + "method = [\"ed\", \"md\"]\nlaw = \"hertz\""), "accepted");
}

TEST(Random, SeedOnlyWhereSomethingIsRandom) {
  EXPECT_EQ(wrong(contact + "seed = 1"),
            "test.toml:7: sweep.seed: no tuple uses it: it needs width > 0, or random_separation = true and a gap");
  expect_part(wrong(contact + "seed = 1\nwidth = 0\nrandom_separation = false"), "sweep.seed: no tuple uses it");
  EXPECT_EQ(wrong(contact + "seed = [1, 2]\nrandom_separation = true"), "accepted");
  EXPECT_EQ(wrong(contact + "seed = [1, 2]\nrandom_separation = [false, true]"), "accepted");
  EXPECT_EQ(wrong(contact + "seed = 1\nwidth = { from = 0, to = 1e-4, count = 3 }"), "accepted");
  expect_part(wrong(contact + "seed = -1\nwidth = 1e-4"), "seed = -1 is not allowed");
  EXPECT_EQ(refusal("v0 = 1\nN = 3\ns0 = 0\n" + contact + "random_separation = true"),
            "test.toml:7: sweep.random_separation: no tuple uses it: it needs a gap: s0 > 0 or sigma > 0");
  expect_part(refusal("v0 = 1\nN = 3\n" + contact +
                      "sigma = [0, 1]\nrandom_separation = [true, false]\n"
                      "zip = [[\"sigma\", \"random_separation\"]]\nseed = 3"),
              "sweep.seed: no tuple uses it");
}

TEST(Random, SeparationIsTrueOrFalse) {
  EXPECT_EQ(with(contact + "random_separation = true").at(0).random_separation, Flag::yes);
  EXPECT_EQ(with(contact + "random_separation = false").at(0).random_separation, Flag::no);
  const Sweep both = with(contact + "random_separation = [true, false]");
  EXPECT_EQ(both.at(0).random_separation, Flag::yes);
  EXPECT_EQ(both.at(1).random_separation, Flag::no);
  EXPECT_EQ(wrong(contact + "random_separation = \"true\""),
            "test.toml:7: sweep.random_separation = \"true\": must be true or false");
  EXPECT_EQ(wrong(contact + "random_separation = [true, 1]"),
            "test.toml:7: sweep.random_separation = 1: must be true or false");
  EXPECT_EQ(wrong(contact + "random_separation = { from = 0, to = 1, count = 2 }"),
            "test.toml:7: sweep.random_separation: must be true or false, or a list of them");
}

TEST(Random, DiametersArePositive) {
  EXPECT_EQ(wrong(contact + "width = 1.8e-3"), "accepted");  // d is 1 mm
  expect_part(wrong(contact + "width = 2e-3"),
              "test.toml:7: sweep.width: with d = 0.001: width = 0.002 is not allowed");
  EXPECT_EQ(wrong(contact + "width = 2e-3\nd = 2e-3"), "accepted");
  expect_part(wrong(contact + "width = [0, 2e-3]\nd = [2e-3, 1e-3]"), "sweep.width: with d = 0.001");
  EXPECT_EQ(wrong(contact + "width = [0, 2e-3]\nd = [1e-3, 2e-3]\nzip = [[\"width\", \"d\"]]"), "accepted");
  expect_part(wrong(contact + "width = [2e-3, 0]\nd = [1e-3, 2e-3]\nzip = [[\"width\", \"d\"]]"), "with d = 0.001");
  EXPECT_EQ(wrong("material = \"steel\"\nwidth = 2.8e-3"), "accepted");  // d is 1.5 mm
  expect_part(wrong("material = \"steel\"\nwidth = 2.99e-3"), "sweep.width: with d = 0.0015");
  expect_part(wrong(contact + "width = -1e-3"), "sweep.width = -0.001 is not allowed");
}

TEST(EdRule, OnlyForHardSpheres) {
  EXPECT_EQ(wrong(contact + "ed_rule = \"tc\""),
            "test.toml:7: sweep.ed_rule: no tuple uses it: it needs method = 'ed'");
  EXPECT_EQ(wrong(contact + "method = \"ed\"\ned_rule = [\"lrv\", \"tc\"]"), "accepted");
  EXPECT_EQ(wrong("epsilon = 0.9\nmethod = \"ed\"\ned_rule = \"lrv\""), "accepted");
  expect_part(wrong("epsilon = 0.9\nmethod = \"ed\"\ned_rule = [\"lrv\", \"tc\"]"), "'tc' is missing");
  expect_part(wrong("epsilon = 0.9\nmethod = [\"ed\", \"md\"]"), "'tc' is missing");
}

TEST(Axes, NewParametersAreColumnsWhereTheyAreGiven) {
  const Sweep sweep = with("K_over_m = [2e9, 3e9]\nD_n = 1\nrandom_separation = [true, false]\nseed = [1, 2]");
  std::vector<std::string> names;
  for (const Field& field : sweep.columns()) names.emplace_back(field.name);
  names.resize(11);
  EXPECT_EQ(names, (std::vector<std::string>{"v0", "tc", "s0", "sigma", "N", "epsilon", "method", "K_over_m", "D_n",
                                             "random_separation", "seed"}));
  EXPECT_EQ(sweep.axes(), (std::vector<std::string>{"K_over_m", "random_separation", "seed"}));
}

TEST(Usage, EveryRuleSaysWhatItNeeds) {
  for (const Field& field : parameter_fields()) {
    Parameters plain;
    plain.method = Method::ed;
    EXPECT_TRUE(applies_to(field, plain) || !requirement_of(field).empty()) << field.name;
  }
  Parameters steel;
  steel.material = Material::steel;
  steel = complete(steel, GapParameter::s0);
  for (const char* follows : {"tc", "epsilon", "K_over_m", "D_n", "d"})
    EXPECT_FALSE(applies_to(*find_field(follows), steel)) << follows;
  EXPECT_TRUE(applies_to(*find_field("material"), steel));
}
