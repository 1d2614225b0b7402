#include "sigmasweep/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <xxhash.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "support/columns.hpp"

using namespace sigmasweep;

namespace {

const std::string fig2a = R"toml(title  = "Universal sigma-curve, Fig. 2(a)"
[sweep]                       # every parameter is a value, or an axis if it has several
method  = ["md", "ed"]
N       = 10
epsilon = 0.9
v0      = [14.0, 1.0, 0.2, 0.05, 0.008]                          # m/s, SI everywhere
tc      = [2.5e-6, 2e-5, 1e-4, 5e-4, 2.2e-3]                     # s
s0      = { from = 1e-9, to = 1e-3, count = 61, scale = "log" }  # m; or give sigma instead of s0
zip     = [["v0", "tc"]]      # these axes advance together; all others multiply, last axis fastest
where   = "sigma > 1e-4 && sigma < 1e4"
[plot]
x = "sigma"
y = "eps_eff"
x_scale = "log"
series = ["v0", "tc"]
)toml";

Sweep sweep(const std::string& body) { return Sweep::parse("[sweep]\n" + body, "test.toml"); }

/// A complete [sweep] with `more` after it.
Sweep with(const std::string& more) { return sweep("v0 = 1.0\ntc = 1e-4\nN = 10\nepsilon = 0.9\n" + more); }

std::vector<double> values(const Sweep& sweep, std::string_view name) {
  std::vector<double> all;
  for (std::uint64_t k = 0; k < sweep.size(); ++k) {
    Row row;
    row.parameters = sweep.at(k);
    all.push_back(number(*find_field(name), row));
  }
  return all;
}

using Doubles = std::vector<double>;

}  // namespace

TEST(Spec, Figure2a) {
  const Sweep sweep = Sweep::parse(fig2a, "fig2a.toml");
  EXPECT_EQ(sweep.title(), "Universal sigma-curve, Fig. 2(a)");
  EXPECT_EQ(sweep.axes(), (std::vector<std::string>{"method", "v0", "tc", "s0"}));
  EXPECT_EQ(sweep.plots()[0].x, "sigma");
  EXPECT_EQ(sweep.plots()[0].y, "eps_eff");
  EXPECT_TRUE(sweep.plots()[0].x_log);
  EXPECT_FALSE(sweep.plots()[0].y_log);
  EXPECT_EQ(sweep.plots()[0].series, (std::vector<std::string>{"v0", "tc"}));

  // What the axes and `where` mean, spelt out: method, then (v0, tc), then s0 fastest.
  const double v0[] = {14.0, 1.0, 0.2, 0.05, 0.008}, tc[] = {2.5e-6, 2e-5, 1e-4, 5e-4, 2.2e-3};
  std::uint64_t row = 0;
  for (const Method method : {Method::md, Method::ed})
    for (int i = 0; i < 5; ++i)
      for (int k = 0; k <= 60; ++k) {
        const double s0 = std::pow(10.0, -9.0 + 0.1 * k), sigma = s0 / (v0[i] * tc[i]);
        if (!(sigma > 1e-4 && sigma < 1e4)) continue;
        ASSERT_LT(row, sweep.size());
        const Parameters p = sweep.at(row++);
        EXPECT_EQ(p.method, method);
        EXPECT_EQ(p.v0, v0[i]);
        EXPECT_EQ(p.tc, tc[i]);
        EXPECT_NEAR(p.s0 / s0, 1.0, 1e-14);  // pow of an inexact exponent
        EXPECT_NEAR(p.sigma / sigma, 1.0, 1e-14);
        EXPECT_EQ(p.N, 10);
        EXPECT_EQ(p.epsilon, 0.9);
      }
  EXPECT_EQ(row, sweep.size());
}

TEST(Spec, KeepsItsTextAndHash) {
  const Sweep sweep = Sweep::parse(fig2a, "fig2a.toml");
  EXPECT_EQ(sweep.text(), fig2a);
  EXPECT_EQ(sweep.hash(), XXH3_64bits(fig2a.data(), fig2a.size()));
}

TEST(Spec, OneTupleWithDefaults) {
  const Sweep one = with("sigma = 0.5");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(one.axes().empty());
  const Parameters p = one.at(0);
  EXPECT_EQ(p.sigma, 0.5);
  EXPECT_DOUBLE_EQ(p.s0, 0.5e-4);  // sigma v0 tc
  EXPECT_EQ(p.method, Method::md);
  EXPECT_EQ(p.wall, Wall::paper);
  EXPECT_EQ(p.integrator, Integrator::exact);
  EXPECT_EQ(p.tolerance, 1e-10);
  EXPECT_THROW(one.at(1), std::out_of_range);
}

TEST(Spec, SigmaFollowsFromS0) { EXPECT_DOUBLE_EQ(with("s0 = 3e-4").at(0).sigma, 3.0); }

TEST(Spec, LastAxisIsFastestInFileOrder) {
  const Sweep sweep =
      with("wall = [\"paper\", \"matched\"]\nsigma = [1, 2, 3]\ngeometry = \"column\"\nlaw = \"hooke\"");
  EXPECT_EQ(sweep.axes(), (std::vector<std::string>{"wall", "sigma"}));
  EXPECT_EQ(values(sweep, "sigma"), (Doubles{1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(values(sweep, "wall"), (Doubles{0, 0, 0, 1, 1, 1}));
  const Sweep other = with("sigma = [1, 2, 3]\nwall = [\"paper\", \"matched\"]");
  EXPECT_EQ(values(other, "sigma"), (Doubles{1, 1, 2, 2, 3, 3}));
}

TEST(Spec, OrderHoldsForSubtablesAndDottedKeys) {
  const Sweep sweep = with("sigma.from = 1\nsigma.to = 3\nsigma.count = 3\nd = [1e-3, 2e-3]\n");
  EXPECT_EQ(sweep.axes(), (std::vector<std::string>{"sigma", "d"}));
  const Sweep table = with("d = [1e-3, 2e-3]\n[sweep.sigma]\nfrom = 1\nto = 3\ncount = 3\n");
  EXPECT_EQ(table.axes(), (std::vector<std::string>{"d", "sigma"}));
  EXPECT_EQ(values(table, "sigma"), (Doubles{1, 2, 3, 1, 2, 3}));
}

TEST(Spec, ZippedGroupStandsWhereItsFirstAxisDoes) {
  const Sweep sweep = Sweep::parse(R"toml([sweep]
v0 = [1, 2]
sigma = [10, 20, 30]
tc = [0.1, 0.2]
N = [5, 6, 7]
epsilon = 0.9
zip = [["tc", "v0"], ["N", "sigma"]]
)toml",
                                   "test.toml");
  ASSERT_EQ(sweep.size(), 6u);
  EXPECT_EQ(values(sweep, "v0"), (Doubles{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(values(sweep, "tc"), (Doubles{0.1, 0.1, 0.1, 0.2, 0.2, 0.2}));
  EXPECT_EQ(values(sweep, "sigma"), (Doubles{10, 20, 30, 10, 20, 30}));
  EXPECT_EQ(values(sweep, "N"), (Doubles{5, 6, 7, 5, 6, 7}));
}

TEST(Spec, AllFormsOfAnAxis) {
  EXPECT_EQ(values(with("sigma = [0.5]"), "sigma"), Doubles{0.5});
  EXPECT_EQ(with("sigma = [0.5]").axes(), std::vector<std::string>{"sigma"});
  EXPECT_EQ(values(with("sigma = { from = 0, to = 1, count = 5 }"), "sigma"), (Doubles{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(values(with("sigma = { from = 1, to = 0, count = 3, scale = \"linear\" }"), "sigma"), (Doubles{1, 0.5, 0}));
  EXPECT_EQ(values(with("sigma = { from = 1e-2, to = 1e2, count = 5, scale = \"log\" }"), "sigma"),
            (Doubles{0.01, 0.1, 1, 10, 100}));
  EXPECT_EQ(values(with("sigma = { sample = \"sobol\", from = 0, to = 1, count = 3 }"), "sigma"),
            (Doubles{0, 0.5, 0.75}));
  const Sweep log = with("sigma = { sample = \"sobol\", from = 0.01, to = 100, count = 3, scale = \"log\" }");
  EXPECT_EQ(values(log, "sigma")[0], 0.01);
  EXPECT_EQ(values(log, "sigma")[1], 1.0);
  for (const char* kind : {"uniform", "log-uniform", "sobol", "latin-hypercube"}) {
    const std::string form = std::string("{ sample = \"") + kind + "\", from = 0.1, to = 10, count = 50, seed = ";
    const Doubles one = values(with("sigma = " + form + "1 }"), "sigma");
    ASSERT_EQ(one.size(), 50u);
    EXPECT_EQ(one, values(with("sigma = " + form + "1 }"), "sigma")) << kind;
    EXPECT_NE(one, values(with("sigma = " + form + "2 }"), "sigma")) << kind;
    EXPECT_EQ(std::set<double>(one.begin(), one.end()).size(), 50u) << kind;
    for (const double sigma : one) EXPECT_TRUE(sigma >= 0.1 && sigma <= 10.0) << kind;
  }
}

TEST(Spec, SampledAxesDoNotDependOnOtherAxes) {
  const std::string form = "sigma = { sample = \"uniform\", from = 0.1, to = 10, count = 4, seed = 3 }\n";
  const Doubles alone = values(with(form), "sigma");
  const Sweep both = with("d = { sample = \"uniform\", from = 0.1, to = 10, count = 4, seed = 3 }\n" + form);
  const Doubles sigma = values(both, "sigma");
  EXPECT_EQ(Doubles(sigma.begin(), sigma.begin() + 4), alone);
  EXPECT_NE(values(both, "d")[0], alone[0]);  // the same seed, another parameter: another stream
}

TEST(Spec, ZippedSobolAxesAreDimensionsOfOneSequence) {
  const Sweep sweep = Sweep::parse(R"toml([sweep]
N = 10
tc = 1e-4
v0      = { sample = "sobol", from = 1, to = 3, count = 4 }
sigma   = { sample = "sobol", from = 0, to = 1, count = 4 }
epsilon = { sample = "sobol", from = 0.5, to = 1, count = 4 }
zip = [["v0", "sigma", "epsilon"]]
)toml",
                                   "test.toml");
  EXPECT_EQ(values(sweep, "v0"), (Doubles{1, 2, 2.5, 1.5}));
  EXPECT_EQ(values(sweep, "sigma"), (Doubles{0, 0.5, 0.25, 0.75}));
  EXPECT_EQ(values(sweep, "epsilon"), (Doubles{0.5, 0.75, 0.625, 0.875}));
}

TEST(Spec, WholeNumbers) {
  const auto beads = [](const std::string& N) {
    return values(sweep("v0 = 1\ntc = 1e-4\nepsilon = 0.9\nsigma = 0\nN = " + N), "N");
  };
  EXPECT_EQ(beads("[1, 2, 5]"), (Doubles{1, 2, 5}));
  EXPECT_EQ(beads("1e2"), Doubles{100});
  EXPECT_EQ(beads("[61.0, +2]"), (Doubles{61, 2}));
  EXPECT_EQ(beads("{ from = 1.0, to = 3e0, count = 3.0 }"), (Doubles{1, 2, 3}));
  EXPECT_EQ(beads("{ from = 10, to = 50, count = 5 }"), (Doubles{10, 20, 30, 40, 50}));
  EXPECT_EQ(beads("{ from = 1, to = 10, count = 10, scale = \"log\" }"), (Doubles{1, 2, 3, 4, 5, 6, 8, 10}));
}

TEST(Spec, SeedsHave64Bits) {
  const Sweep seeds = sweep(
      "v0 = 1\ntc = 1e-4\nepsilon = 0.9\nN = 3\nwidth = 1e-4\nsigma = 0\n"
      "seed = [9007199254740991, 9007199254740992, 9007199254740993, 9223372036854775807]");
  EXPECT_EQ(seeds.at(0).seed, 9007199254740991);
  EXPECT_EQ(seeds.at(2).seed, 9007199254740993);
  EXPECT_EQ(seeds.at(3).seed, INT64_MAX);
  std::set<std::uint64_t> keys;
  for (std::uint64_t k = 0; k < seeds.size(); ++k) keys.insert(content_key(seeds.at(k)));
  EXPECT_EQ(keys.size(), 4u);
}

TEST(Spec, WhereKeepsTheOrder) {
  const Sweep sweep = with(
      "method = [\"md\", \"ed\"]\nsigma = [1, 2, 3, 4]\n"
      "where = \"sigma > 2 && method == ed || sigma == 1\"");
  EXPECT_EQ(values(sweep, "sigma"), (Doubles{1, 1, 3, 4}));
  EXPECT_EQ(values(sweep, "method"), (Doubles{0, 1, 1, 1}));
}

TEST(Spec, HardSpheresNeedNoContactTime) {
  const Sweep sweep = Sweep::parse("[sweep]\nmethod = \"ed\"\nv0 = 1\nN = 10\nepsilon = 0.9\ns0 = 1e-4\n", "test.toml");
  EXPECT_EQ(sweep.at(0).method, Method::ed);
  EXPECT_EQ(sweep.at(0).s0, 1e-4);
  EXPECT_GT(sweep.at(0).tc, 0.0);
}

TEST(Spec, ParametersThatSomeTuplesUseAreAccepted) {
  const Sweep both = with("sigma = 1\nintegrator = [\"exact\", \"gear5\"]\nsteps_per_tc = [50, 100]\ntolerance = 1e-8");
  EXPECT_EQ(both.size(), 4u);
  const Sweep zipped = with(
      "sigma = 1\nmethod = [\"ed\", \"md\"]\nintegrator = [\"exact\", \"rk4\"]\n"
      "zip = [[\"method\", \"integrator\"]]\nsteps_per_tc = 100");
  EXPECT_EQ(zipped.size(), 2u);
}

TEST(Spec, ATimeStepIsGivenOrChosenByTheTolerance) {
  EXPECT_EQ(with("sigma = 1\nintegrator = \"gear5\"").at(0).steps_per_tc, 100.0);
  const Sweep chosen = with("sigma = 1\nintegrator = [\"gear5\", \"rk4\"]\ntolerance = [1e-3, 1e-4]");
  ASSERT_EQ(chosen.size(), 4u);
  for (std::uint64_t row = 0; row < 4; ++row) EXPECT_EQ(chosen.at(row).steps_per_tc, 0.0);
  EXPECT_EQ(std::ranges::count(chosen.columns(), "steps_used", &Field::name), 1);
  const Sweep given = with("sigma = 1\nintegrator = \"gear5\"\nsteps_per_tc = 50");
  EXPECT_EQ(std::ranges::count(given.columns(), "steps_used", &Field::name), 0);  // it is steps_per_tc
  EXPECT_EQ(chosen.at(3).tolerance, 1e-4);
  EXPECT_EQ(with("sigma = 1\ntolerance = 1e-4").at(0).steps_per_tc, 100.0);  // nobody steps
}

TEST(Spec, TwoToTheFortiethTuplesCostNothing) {
  const Sweep sweep = Sweep::parse(R"toml([sweep]
N = { from = 1, to = 1024, count = 1024 }
v0 = { from = 1, to = 1048576, count = 1048576 }
sigma = { from = 1, to = 1024, count = 1024 }
tc = 1e-4
epsilon = 0.9
)toml",
                                   "test.toml");
  ASSERT_EQ(sweep.size(), std::uint64_t{1} << 40);
  const Parameters p = sweep.at(((std::uint64_t{700} << 20 | 123456) << 10) | 77);
  EXPECT_EQ(p.N, 701);
  EXPECT_EQ(p.v0, 123457.0);
  EXPECT_EQ(p.sigma, 78.0);
  EXPECT_EQ(sweep.at(sweep.size() - 1).sigma, 1024.0);
}

TEST(Spec, ColumnsAreWhatIsGivenPlusResults) {
  const auto names = [](const Sweep& sweep) {
    std::vector<std::string> all;
    for (const Field& field : sweep.columns()) all.emplace_back(field.name);
    return all;
  };
  auto expected = golden::table_of(Geometry::column);
  EXPECT_EQ(names(with("sigma = 1")), expected);
  expected.insert(expected.begin() + 7, {"wall", "tolerance"});
  EXPECT_EQ(names(with("sigma = 1\ntolerance = 1e-8\nwall = \"matched\"")), expected);
  EXPECT_EQ(names(with("sigma = 1\ntolerance = [1e-8, 1e-10]\nwall = [\"paper\", \"matched\"]")), expected);
}

TEST(Spec, PlotAndRun) {
  const Sweep plain = with("sigma = 1");
  EXPECT_EQ(plain.manager(), ManagerRole::automatic);
  EXPECT_EQ(plain.plots()[0].x, "sigma");
  EXPECT_TRUE(plain.plots()[0].series.empty());
  const Sweep other = with(
      "sigma = 1\n[run]\nmanager = \"dedicated\"\n[plot]\nx = \"N\"\ny = \"run_time\"\nx_scale = "
      "\"linear\"\ny_scale = \"log\"\ntitle = \"T\"\n");
  EXPECT_EQ(other.manager(), ManagerRole::dedicated);
  EXPECT_EQ(other.plots()[0].x, "N");
  EXPECT_EQ(other.plots()[0].y, "run_time");
  EXPECT_FALSE(other.plots()[0].x_log);
  EXPECT_TRUE(other.plots()[0].y_log);
  EXPECT_EQ(other.plots()[0].title, "T");
}

TEST(Spec, LoadsFilesAndSaysWhichIsMissing) {
  const auto path = std::filesystem::path(testing::TempDir()) / "sweep_spec_test.toml";
  std::ofstream(path) << fig2a;
  EXPECT_EQ(Sweep::load(path.string()).text(), fig2a);
  std::filesystem::remove(path);
  EXPECT_THROW(Sweep::load(path.string()), InputNotFound);
  EXPECT_THROW(Sweep::load(testing::TempDir()), InputNotFound);  // a directory
  EXPECT_THROW(Sweep::load("/dev/zero"), SpecError);             // endless
}
