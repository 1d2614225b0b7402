#include "sigmasweep/sweep/sweep.hpp"

#include <algorithm>
#include <ctime>
#include <string>

#include <gtest/gtest.h>

#include "support/spec_refusal.hpp"

using namespace sigmasweep;

namespace {

std::string refusal(const std::string& text) { return refusal_of(text, "bad.toml"); }

/// [sweep] on line 1, complete but for the gap, `more` from line 2 on.
std::string with(const std::string& more) {
  return refusal("[sweep]\n" + more + "\nv0 = 1.0\ntc = 1e-4\nN = 10\nepsilon = 0.9\n");
}
/// The same with the gap; the given key from line 3 on.
std::string alone(const std::string& more) { return with("sigma = 1\n" + more); }

/// A complete sweep with `more`, another table, from line 7 on.
std::string table(const std::string& more) {
  return refusal("[sweep]\nv0 = 1.0\ntc = 1e-4\nN = 10\nepsilon = 0.9\nsigma = 1\n" + more);
}

}  // namespace

TEST(Refusal, UnknownKeysNameTheNearest) {
  EXPECT_EQ(alone("epsilom = 1"), "bad.toml:3: unknown key sweep.epsilom (did you mean 'epsilon'?)");
  EXPECT_EQ(refusal("[swep]\n"), "bad.toml:1: unknown key swep (did you mean 'sweep'?)");
  EXPECT_EQ(table("[plot]\nxscale = \"log\""), "bad.toml:8: unknown key plot.xscale (did you mean 'x_scale'?)");
  expect_part(alone("pressure = 1e5"), "bad.toml:3: unknown key sweep.pressure; known: v0, tc,");
  EXPECT_EQ(with("sigma = { from = 1, to = 2, cont = 3 }"),
            "bad.toml:2: unknown key sweep.sigma.cont (did you mean 'count'?)");
  EXPECT_EQ(table("[run]\nranks = 3"), "bad.toml:8: unknown key run.ranks; known: manager, tuple_time_limit");
}

TEST(Refusal, SyntaxErrorsKeepTheLibrarysWords) {
  expect_part(refusal("[sweep]\nv0 = = 1\n"), "bad.toml:2: Error while parsing");
  expect_part(alone("N = 3"), "bad.toml:6: Error while parsing key-value pair: cannot redefine existing");
  expect_part(refusal("title = \"\xff\xfe\"\n"), "bad.toml:1: ");
}

TEST(Refusal, SyntaxErrorsShowTheFormThatIsWanted) {
  const auto expect_end = [](const std::string& line, const std::string& end) {
    const std::string message = alone(line);
    expect_part(message, "bad.toml:3: Error while parsing");
    EXPECT_TRUE(message.ends_with(end)) << message;
  };
  expect_end("tolerance = 2*10^-5", " (write 2e-5)");
  expect_end("d = [1e-3, 2*10^-3]", " (write 2e-3)");
  expect_end("d = { from = 1*10^-3, to = 1, count = 3 }", " (write 1e-3)");
  expect_end("d = .5", " (write 0.5)");
  expect_end("d = 1.", " (write 1)");
  expect_end("method = [md, ed]", " (names need quotes: \"md\")");
  expect_end("law = hertz-kuwabara-kono", " (names need quotes: \"hertz-kuwabara-kono\")");
  EXPECT_EQ(alone("d = \"2*10^-3\""), "accepted");  // an expression
}

TEST(Refusal, AllMistakesAreReportedTogether) {
  EXPECT_EQ(refusal("titel = \"x\"\n[sweep]\nv0 = -1\ntc = true\nepsilom = 0.9\nN = [1, 2.5]\nzip = 1\n"
                    "where = \"N + 1\"\n[plot]\nx_scale = \"cubic\"\nyy = 1\n[run]\nmanager = 1\nranks = 3\n"
                    "[trajectory]\nsamples = 1\n"),
            "bad.toml:1: unknown key titel (did you mean 'title'?)\n"
            "bad.toml:7: sweep.zip = 1: must be a list\n"
            "bad.toml:3: sweep.v0 = -1 is not allowed: it must be a finite speed > 0 m/s.\n"
            "bad.toml:4: sweep.tc = true: must be a number\n"
            "bad.toml:5: unknown key sweep.epsilom (did you mean 'epsilon'?)\n"
            "bad.toml:6: sweep.N = 2.5: must be a whole number\n"
            "bad.toml:8: sweep.where = \"N + 1\": it must be boolean, such as 'sigma > 1'\n"
            "bad.toml:13: run.manager = 1: must be 'auto', 'computes' or 'dedicated'\n"
            "bad.toml:14: unknown key run.ranks; known: manager, tuple_time_limit\n"
            "bad.toml:16: trajectory.samples = 1: must be a whole number from 2 to 1000000\n"
            "bad.toml:10: plot.x_scale = \"cubic\": must be 'linear' or 'log'\n"
            "bad.toml:11: unknown key plot.yy (did you mean 'y'?)");
  // Syntax, too; a line that is no TOML is not reported as missing.
  const std::string syntax = refusal("[sweep]\nv0 = 2*10^1\nmethod = [md, ed]\ntc = 1e-4\nepsilon = 2\ns0 = 0\n");
  expect_part(syntax, "bad.toml:2: Error");
  expect_part(syntax, "\nbad.toml:3: Error");
  expect_part(syntax, "\nbad.toml:5: sweep.epsilon = 2 is not allowed");
  EXPECT_EQ(std::count(syntax.begin(), syntax.end(), '\n'), 2) << syntax;
  // What follows from a mistake is not reported with it.
  EXPECT_EQ(refusal("[sweep]\nN = 1.5\n"), "bad.toml:2: sweep.N = 1.5: must be a whole number");
  EXPECT_EQ(
      refusal("[sweep]\nsigma = 1\nepsilon = 0.9\n"),
      "bad.toml:1: sweep: 'v0', 'tc', 'N' are missing: v0, N, one of s0 and sigma, and tc and epsilon (or instead "
      "of these K_over_m and D_n, or a material) are needed");
  EXPECT_EQ(alone("seed = 1\nD_t = 3"),
            "bad.toml:3: sweep.seed: no tuple uses it: it needs width > 0, or random_separation = true and a gap\n"
            "bad.toml:4: sweep.D_t: no tuple uses it: it needs geometry = 'lattice' or 'vibrated-lattice'");
  std::string many = "[sweep]\n";
  for (int k = 0; k < 30; ++k) many += "d" + std::to_string(k) + "x = 1\n";
  EXPECT_TRUE(refusal(many).ends_with("\nand 10 more mistakes")) << refusal(many);
}

TEST(Refusal, ValuesOutOfRange) {
  EXPECT_EQ(with("sigma = -1"),
            "bad.toml:2: sweep.sigma = -1 is not allowed: it must be finite and >= 0 (sigma = s0/(v0 tc)).");
  expect_part(refusal("[sweep]\nepsilon = 1.5\n"), "bad.toml:2: sweep.epsilon = 1.5 is not allowed: it must be");
  expect_part(refusal("[sweep]\nepsilon = [0.9,\n 0.8,\n 0.0]\n"), "bad.toml:4: sweep.epsilon = 0 is not allowed");
  expect_part(refusal("[sweep]\nv0 = inf\n"), "bad.toml:2: sweep.v0 = inf is not allowed");
  expect_part(refusal("[sweep]\nv0 = nan\n"), "bad.toml:2: sweep.v0 = nan is not allowed");
  expect_part(refusal("[sweep]\ntc = 0\n"), "bad.toml:2: sweep.tc = 0 is not allowed");
  expect_part(refusal("[sweep]\nN = 0\n"), "bad.toml:2: sweep.N = 0 is not allowed");
  EXPECT_EQ(refusal("[sweep]\nN = 2.5\n"), "bad.toml:2: sweep.N = 2.5: must be a whole number");
  EXPECT_EQ(refusal("[sweep]\nN = 1e300\n"), "bad.toml:2: sweep.N = 1e+300: must be a whole number");
  expect_part(refusal("[sweep]\nN = 9223372036854775807\n"),
              "bad.toml:2: sweep.N = 9223372036854775807 is not allowed");
  expect_part(alone("tolerance = 0"), "bad.toml:3: sweep.tolerance = 0 is not allowed");
  expect_part(alone("d = -1e-3"), "bad.toml:3: sweep.d = -0.001 is not allowed");
  expect_part(with("sigma = { from = -1, to = 1, count = 3 }"), "bad.toml:2: sweep.sigma = -1 is not allowed");
}

TEST(Refusal, WrongTypes) {
  expect_part(refusal("[sweep]\nv0 = \"1 m\"\n"),
              "bad.toml:2: sweep.v0 = \"1 m\": must be a number, or an expression: ");
  EXPECT_EQ(refusal("[sweep]\nv0 = true\n"), "bad.toml:2: sweep.v0 = true: must be a number");
  EXPECT_EQ(refusal("[sweep]\nv0 = 1979-05-27\n"), "bad.toml:2: sweep.v0 = a date or time: must be a number");
  EXPECT_EQ(refusal("[sweep]\nv0 = [[1]]\n"), "bad.toml:2: sweep.v0 = [...]: must be a number");
  EXPECT_EQ(alone("method = 1"), "bad.toml:3: sweep.method = 1: must be 'md' or 'ed'");
  EXPECT_EQ(alone("method = { from = 1, to = 2, count = 2 }"),
            "bad.toml:3: sweep.method: must be a name or a list of names: 'md' or 'ed'");
  EXPECT_EQ(refusal("title = 1\n"), "bad.toml:1: title = 1: must be a string");
  EXPECT_EQ(refusal("sweep = 1\n"), "bad.toml:1: sweep = 1: must be a table");
  EXPECT_EQ(refusal("sweep = [1]\n"), "bad.toml:1: sweep = 1: must be a table");
  EXPECT_EQ(alone("where = 1"), "bad.toml:3: sweep.where = 1: must be a string");
  EXPECT_EQ(alone("zip = \"v0\""), "bad.toml:3: sweep.zip = \"v0\": must be a list");
}

TEST(Refusal, UnknownNames) {
  EXPECT_EQ(alone("method = \"mdd\""), "bad.toml:3: sweep.method = \"mdd\": must be 'md' or 'ed' (did you mean 'md'?)");
  EXPECT_EQ(alone("integrator = [\"gear\"]"),
            "bad.toml:3: sweep.integrator = \"gear\": must be 'exact', 'gear5', 'verlet', 'rk4' or 'leapfrog' "
            "(did you mean 'gear5'?)");
  EXPECT_EQ(alone("geometry = \"latice\""),
            "bad.toml:3: sweep.geometry = \"latice\": must be 'column', 'vibrated-column', 'lattice' or "
            "'vibrated-lattice' (did you mean 'lattice'?)");
  EXPECT_EQ(
      alone("law = \"herz\""),
      "bad.toml:3: sweep.law = \"herz\": must be 'hooke', 'hertz', 'hertz-kuwabara-kono', 'taguchi', 'power' or 'cone' "
      "(did you mean 'hertz'?)");
  expect_part(table("[plot]\ny = \"eps\""),
              "bad.toml:8: plot.y = \"eps\": is no field of a row (did you mean 'epsilon'?)");
  expect_part(table("[plot]\nseries = [\"v0\",\n\"tcc\"]"), "bad.toml:9: plot.series = \"tcc\": is no field");
  EXPECT_EQ(table("[plot]\nx_scale = \"lin\""),
            "bad.toml:8: plot.x_scale = \"lin\": must be 'linear' or 'log' (did you mean 'linear'?)");
  EXPECT_EQ(table("[run]\nmanager = \"boss\""),
            "bad.toml:8: run.manager = \"boss\": must be 'auto', 'computes' or 'dedicated'");
}

TEST(Refusal, RangesAndSamples) {
  const auto range = [](const std::string& form) { return with("sigma = {" + form + "}"); };
  expect_part(range("from = 1, to = 2"), "bad.toml:2: sweep.sigma: 'count' is missing");
  expect_part(range(""), "bad.toml:2: sweep.sigma: 'from' is missing");
  expect_part(range("from = 1, to = 2, count = 0"), "bad.toml:2: sweep.sigma.count = 0: must be a whole number from 1");
  expect_part(range("from = 1, to = 2, count = -3"), "bad.toml:2: sweep.sigma.count = -3: must be a whole number");
  expect_part(range("from = 1, to = 2, count = 2.5"), "bad.toml:2: sweep.sigma.count = 2.5: must be a whole number");
  expect_part(range("from = 1, to = 2, count = 1000000000000000000"),
              "bad.toml:2: sweep.sigma.count = 1000000000000000000");
  expect_part(range("from = 1, to = 2, count = 1"), "bad.toml:2: sweep.sigma.count = 1: both 'from' and 'to'");
  EXPECT_EQ(range("from = 0, to = 2, count = 3, scale = \"log\""),
            "bad.toml:2: sweep.sigma.from = 0: a logarithmic axis needs from > 0 and to > 0");
  expect_part(range("from = 0, to = 2, count = 3, sample = \"log-uniform\""),
              "sweep.sigma.from = 0: a logarithmic axis");
  expect_part(range("from = 1, to = 2, count = 3, scale = \"cubic\""), "must be 'linear' or 'log'");
  expect_part(range("from = 1, to = 2, count = 3, sample = \"random\""),
              "must be 'uniform', 'log-uniform', 'sobol', 'latin-hypercube', 'normal' or 'log-normal'");
  expect_part(range("from = 2, to = 1, count = 3, sample = \"uniform\""),
              "bad.toml:2: sweep.sigma.from = 2: must not be above");
  expect_part(range("from = 1, to = 2, count = 3, seed = 3"), "bad.toml:2: sweep.sigma.seed: only a sample has a seed");
  expect_part(range("from = 1, to = 2, count = 3, sample = \"sobol\", seed = -1"), "sweep.sigma.seed = -1: must be");
  expect_part(range("from = 1, to = 2, count = 3, sample = \"uniform\", scale = \"log\""),
              "sweep.sigma.scale: is given by");
  EXPECT_EQ(refusal("[sweep]\nN = { from = 1, to = 10, count = 5 }\n"),
            "bad.toml:2: sweep.N.count = 5: 5 values from 1 to 10 are not all whole numbers");
  expect_part(refusal("[sweep]\nN = { from = 1, to = 10, count = 100000000, scale = \"log\" }\n"), "at most 1048576");
  EXPECT_EQ(with("sigma = []"), "bad.toml:2: sweep.sigma: an axis needs at least one value, this list is empty");
}

TEST(Refusal, MissingParameters) {
  EXPECT_EQ(refusal("title = \"x\"\n"), "bad.toml: the table [sweep] is missing");
  EXPECT_EQ(refusal("\n[sweep]\nv0 = 1\ntc = 1\nepsilon = 1\nsigma = 1\n"),
            "bad.toml:2: sweep: 'N' is missing: v0, N, one of s0 and sigma, and tc and epsilon (or instead of these "
            "K_over_m and D_n, or a material) are needed");
  EXPECT_EQ(with(""), "bad.toml:1: sweep: one of 's0' and 'sigma' is missing");
  EXPECT_EQ(with("s0 = 1e-4\nsigma = 1"), "bad.toml:3: sweep.sigma: give s0 or sigma, not both: sigma = s0/(v0 tc)");
  const std::string hard = "[sweep]\nv0 = 1\nN = 3\nepsilon = 1\nsigma = 1\nmethod = ";
  EXPECT_EQ(refusal(hard + "[\"ed\"]\n"), "accepted");
  expect_part(refusal(hard + "[\"ed\", \"md\"]\n"), "'tc' is missing");
}

TEST(Refusal, ParametersThatNothingUses) {
  EXPECT_EQ(
      alone("steps_per_tc = 50"),
      "bad.toml:3: sweep.steps_per_tc: no tuple uses it: it needs integrator = 'gear5', 'verlet', 'rk4' or 'leapfrog'");
  expect_part(alone("integrator = \"gear5\"\ntolerance = 1e-8\nsteps_per_tc = 50"),
              "bad.toml:4: sweep.tolerance: 'steps_per_tc' and 'tolerance' conflict");
  expect_part(alone("integrator = \"gear5\"\nsteps_per_tc = 0"), "bad.toml:4: sweep.steps_per_tc: must be from 2");
  expect_part(alone("method = \"ed\"\nintegrator = \"exact\""), "bad.toml:4: sweep.integrator: no tuple uses it");
  expect_part(alone("method = \"ed\"\ntolerance = 1e-8"), "bad.toml:4: sweep.tolerance: no tuple uses it");
  expect_part(alone("method = [\"md\", \"ed\"]\nintegrator = [\"exact\", \"rk4\"]\n"
                    "zip = [[\"method\", \"integrator\"]]\nsteps_per_tc = 50"),
              "bad.toml:6: sweep.steps_per_tc: no tuple uses it");
}

TEST(Refusal, Zip) {
  const auto zip = [](const std::string& list) { return with("sigma = [1, 2]\nd = [1, 2, 3]\nzip = " + list); };
  EXPECT_EQ(zip("[[\"sigma\", \"d\"]]"),
            "bad.toml:4: sweep.zip: zipped axes must be of equal length: 'sigma' has 2 values, 'd' has 3");
  EXPECT_EQ(zip("[[\"sigma\", \"v0\"]]"), "bad.toml:4: sweep.zip: 'v0' is not an axis; axes: sigma, d");
  EXPECT_EQ(zip("[[\"sigma\", \"sigma\"]]"), "bad.toml:4: sweep.zip = \"sigma\": is zipped already");
  EXPECT_EQ(zip("[[\"sigma\", \"d\"], [\"d\", \"v0\"]]"), "bad.toml:4: sweep.zip = \"d\": is zipped already");
  EXPECT_EQ(zip("[\"sigma\", \"d\"]"),
            "bad.toml:4: sweep.zip = \"sigma\": must be a list of groups, such as [[\"v0\", \"tc\"]]");
  EXPECT_EQ(zip("[[\"sigma\"]]"), "bad.toml:4: sweep.zip: a group needs at least two axes");
}

TEST(Refusal, Where) {
  EXPECT_EQ(alone("where = \"sigma + 1\""),
            "bad.toml:3: sweep.where = \"sigma + 1\": it must be boolean, such as 'sigma > 1'");
  EXPECT_EQ(alone("where = \"sgima > 1\""),
            "bad.toml:3: sweep.where = \"sgima > 1\": unknown name 'sgima' (did you mean 'sigma'?)");
  expect_part(alone("where = \"sigma > 0 && N = 1\""), ": '=' assigns; to compare write '=='");
  EXPECT_EQ(alone("where = \"sigma > 1\""), "bad.toml:3: sweep.where = \"sigma > 1\": no tuple satisfies it");
}

TEST(Refusal, TooManyTuples) {
  const std::string axis = " = { from = 1, to = 2, count = 1048577 }\n";
  EXPECT_EQ(refusal("[sweep]\nN = 1\nepsilon = 1\ntc = 1\nv0" + axis + "sigma" + axis),
            "bad.toml:1: sweep: the axes multiply to 1099513724929 tuples, at most 2^40 = 1099511627776 are allowed");
  expect_part(with("sigma = { from = 1, to = 2, count = 1000000000 }\nwhere = \"sigma > 1\""),
              "bad.toml:3: sweep.where: the axes multiply to 1000000000 tuples, with a 'where' of this length at most "
              "67108864 are allowed");
  const std::string wide(631, ' ');  // 640 characters: a tenth
  expect_part(with("sigma = { from = 1, to = 2, count = 10000000 }\nwhere = \"sigma > 1" + wide + "\""),
              "at most 6710886 are allowed");
}

TEST(Refusal, GapsThatOverflow) {
  expect_part(refusal("[sweep]\nN = 1\nepsilon = 1\nv0 = [1, 1e-200]\ntc = 1e-4\ns0 = 1e200\n"),
              "bad.toml:6: sweep.s0: with v0 = 1e-200, tc = 0.0001 and s0 = 1e+200: sigma = inf is not allowed");
  expect_part(refusal("[sweep]\nN = 1\nepsilon = 1\nv0 = 1\ntc = { from = 1, to = 1e-320, count = 2 }\ns0 = 1\n"),
              "sigma = inf is not allowed");
  expect_part(refusal("[sweep]\nN = 1\nepsilon = 1\nv0 = 1e200\ntc = 1e200\nsigma = 1\n"),
              "bad.toml:6: sweep.sigma: with v0 = 1e+200, tc = 1e+200 and sigma = 1: s0 = inf is not allowed");
}

TEST(Refusal, SpecsThatWouldExhaustTheMachine) {
  const std::clock_t start = std::clock();
  const auto repeated = [](std::string_view part, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += part;
    return all;
  };
  expect_part(refusal("[a" + repeated(".a", 1000000) + "]\n"), "bad.toml:1: a key of more than 32 dotted parts");
  expect_part(refusal("\n'a'" + repeated(" . \"a.,=\"", 100000) + " = 1\n"),
              "bad.toml:2: a key of more than 32 dotted");
  expect_part(refusal("x = " + repeated("[", 100000)), "bad.toml:1: Error while parsing");
  expect_part(refusal("x = " + repeated("{ a = ", 100000)), "bad.toml:1: Error while parsing");
  expect_part(refusal(repeated("#", 5000000)), "bad.toml: a spec may have at most 4194304 bytes");
  expect_part(with("sigma = [" + repeated("1,", 1000000) + "-1]"), "sweep.sigma = -1 is not allowed");
  expect_part(alone("where = \"" + repeated("(", 1000) + "\""), "bad.toml:3: sweep.where");
  const std::string message = alone("where = \"" + repeated("N > 1 && ", 10000) + "N > 1\"");
  expect_part(message, "at most 1024 characters");
  EXPECT_LT(message.size(), 300u);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10.0);  // about 1 s; far from a hang
}

TEST(Refusal, DotsInStringsAndCommentsAreNoKeys) {
  const std::string dots(100, '.');
  std::string decimals = "1.0";
  for (int i = 0; i < 100; ++i) decimals += ", 1.0";
  const std::string rest = "[sweep]\nv0 = 1\ntc = 1\nN = 1\nepsilon = 1\nsigma = 1\nd = [" + decimals + "]\n";
  EXPECT_EQ(refusal("title = \"" + dots + "\" # " + dots + "\n" + rest), "accepted");
  EXPECT_EQ(refusal("title = \"\"\"a\n\"\" " + dots + "\\\"\"\"\"\n" + rest), "accepted");
  EXPECT_EQ(refusal("[plot]\ntitle = '''" + dots + "'''\n" + rest), "accepted");
}
