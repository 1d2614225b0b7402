#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "studies/sections.hpp"

// Whatever the bytes: Sweep::parse returns a sweep of valid rows or throws SpecError, and soon.

using namespace sigmasweep;

namespace {

const std::vector<std::string> seeds{
    R"toml([defaults]
v0 = 1
N = [2, 3]
epsilon = { sample = "normal", mean = 0.8, sd = 0.05, to = 1 }
sigma = { from = 0.1, to = 10, scale = "log" }
sample = { method = "latin-hypercube", of = ["epsilon", "sigma"], count = 8, seed = 3 }
[[sweep]]
tc = "1e-5*N"
d = "v0/1000"
[[sweep]]
method = "ed"
points = '''
# measured
tc, seed
1e-5, +3
2e-5, 4
'''
random_separation = true
)toml",
    R"toml(title  = "Universal sigma-curve, Fig. 2(a)"
[sweep]
method  = ["md", "ed"]
N       = 10
epsilon = 0.9
v0      = [14.0, 1.0, 0.2, 0.05, 0.008]   # m/s
tc      = [2.5e-6, 2e-5, 1e-4, 5e-4, 2.2e-3]
s0      = { from = 1e-9, to = 1e-3, count = 61, scale = "log" }
zip     = [["v0", "tc"]]
where   = "sigma > 1e-4 && sigma < 1e4"
[plot]
x = "sigma"
y = "eps_eff"
x_scale = "log"
series = ["v0", "tc"]
)toml",
    R"toml([sweep]
v0 = 1
tc.from = 1e-5
tc.to = 1e-3
tc.count = 4
N = { from = 1, to = 100, count = 7, scale = "log" }
epsilon = { sample = "sobol", from = 0.5, to = 1, count = 16, seed = 3 }
sigma = { sample = "latin-hypercube", from = 0.1, to = 10, count = 16, scale = "log" }
zip = [["epsilon", "sigma"]]
integrator = ["exact", "gear5"]
steps_per_tc = 100
where = "!(N < 3) || integrator == exact ? abs(sigma - 1) < 5 : max(N, 2) >= 2"
[run]
manager = "auto"
[[plot]]
x = "N*tc"
y = "(1 - eps_eff)/(1 - epsilon)"
where = "N > 1"
mean_over = "sigma"
fit = { form = "power", from = 1, to = 10 }
[[plot]]
name = "b"
y_scale = "log"
lines = true
guides = [{ slope = -0.5, label = "a", through = [1, 2.0] }, { y = 0.3 }, { slope = 1, where = "N == 2" }]
)toml",
    R"toml([sweep]
v0 = { from = 0.01, to = 10, count = 3, scale = "log" }
N = 3
s0 = [0, 1e-6]
law = ["hooke", "power"]
beta = [0.5, 0.25]
gamma = 0.5
K_over_m = [2e9, 2e12]
D_n = 1e3
zip = [["law", "K_over_m"]]
width = 1e-4
random_separation = [true, false]
seed = 3
where = "law == power && random_separation == true || s0 == 0"
)toml",
    "[sweep]\nv0=1\nN=2\ns0=0\nmaterial=['steel','aluminium']\nlaw=['hertz','hooke']\n",
    R"toml([sweep]
geometry = ["lattice", "column", "vibrated-lattice"]
method = ["md", "ed"]
rows = { from = 2, to = 20, count = 3, scale = "log" }
columns = [3, 13, 1000]
N = [2, 6, 20]
zip = [["rows", "N"]]
alpha = 2
v0 = 1
tc = 1e-5
epsilon = 0.9
s0 = 1e-6
D_t = 10
side_walls = ["periodic", "fixed"]
random_separation = true
where = "method == md || geometry == column"
[plot]
x = "geometry == lattice ? rows : N"
series = ["geometry", "side_walls"]
)toml",
    R"toml([sweep]
method = 'ed'
v0 = 1
N = 3
epsilon = 1
sigma = { sample = 'uniform', from = 0, to = 1, count = 9 }
)toml"};

const std::vector<std::string> tokens{"[",
                                      "]",
                                      "{",
                                      "}",
                                      "=",
                                      ",",
                                      ".",
                                      "\"",
                                      "'",
                                      "\"\"\"",
                                      "#",
                                      "\n",
                                      "[sweep]",
                                      "[[sweep]]",
                                      "sweep.",
                                      "where = \"",
                                      "&&",
                                      "||",
                                      "!",
                                      "(",
                                      ")",
                                      "<",
                                      "==",
                                      "?",
                                      ":",
                                      "sigma",
                                      "N",
                                      "md",
                                      "exact",
                                      "inf",
                                      "nan",
                                      "-",
                                      "1e308",
                                      "1e-320",
                                      "0",
                                      "9223372036854775807",
                                      "-9223372036854775808",
                                      "1e400",
                                      "0x10",
                                      "count = 1000000000000",
                                      "true",
                                      "1979-05-27",
                                      "\\u0000",
                                      "\xff",
                                      "\xe2\x82",
                                      std::string(1, '\0'),
                                      "seed = ",
                                      "scale = \"log\"",
                                      "zip = [[",
                                      "from = 0",
                                      "^",
                                      "*",
                                      "-1"};

class Fuzzer {
 public:
  explicit Fuzzer(std::uint64_t seed) : generator_(seed) {}

  std::string mutated() {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t edits = 1 + below(6); edits > 0; --edits) edit(text);
    return text;
  }

  std::string random() {
    std::string text;
    if (below(2) == 0)
      for (std::size_t i = below(60); i > 0; --i) text += tokens[below(tokens.size())];
    else
      for (std::size_t i = below(300); i > 0; --i) text += static_cast<char>(below(256));
    return text;
  }

  /// A valid spec but for a `where` of random tokens.
  std::string random_where() {
    static const std::vector<std::string> words{"sigma", "N", "method", "md", "ed", "1",    "0.5",  "(", ")",   "&&",
                                                "||",    "!", "<",      ">",  "==", "!=",   "+",    "-", "*",   "/",
                                                "^",     "?", ":",      ",",  "=",  "abs(", "max(", " ", "1e-3"};
    std::string expression;
    for (std::size_t i = 1 + below(12); i > 0; --i) expression += words[below(words.size())];
    return "[sweep]\nv0=1\ntc=1\nN=[1,2]\nepsilon=1\nsigma=[0,1]\nmethod=['md','ed']\nwhere='" + expression + "'\n";
  }

 private:
  std::size_t below(std::size_t bound) { return generator_() % bound; }

  void edit(std::string& text) {
    const std::size_t place = below(text.size() + 1), length = below(12);
    switch (below(5)) {
      case 0: text.insert(place, tokens[below(tokens.size())]); break;
      case 1: text.erase(place, length); break;
      case 2: text.replace(place, std::min(length, text.size() - place), tokens[below(tokens.size())]); break;
      case 3: text.insert(place, text.substr(below(text.size() + 1), length)); break;
      default:
        if (place < text.size()) text[place] = static_cast<char>(below(256));
    }
  }

  std::mt19937_64 generator_;
};

/// A fresh seed, or that of the environment to repeat a failure.
std::uint64_t chosen_seed() {
  const char* given = std::getenv("SIGMASWEEP_FUZZ_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

/// Empty when all is well.
std::string complaint(const std::string& text) {
  try {
    const Sweep sweep = Sweep::parse(text, "fuzz.toml", study_sections);
    if (sweep.size() == 0) return "a sweep without rows";
    for (const std::uint64_t row : {std::uint64_t{0}, sweep.size() / 2, sweep.size() - 1})
      if (std::string why = why_invalid(sweep.at(row)); !why.empty()) return why;
    return {};
  } catch (const SpecError& error) {
    const std::string message = error.what();
    return message.starts_with("fuzz.toml:") ? "" : "message without file: " + message;
  } catch (const std::exception& error) {
    return std::string("not a SpecError: ") + error.what();
  }
}

void run(std::string (Fuzzer::*make)(), int times) {
  const std::uint64_t seed = chosen_seed();
  std::cout << "SIGMASWEEP_FUZZ_SEED=" << seed << std::endl;  // at once: a crash must not lose it
  Fuzzer fuzzer(seed);
  for (int i = 0; i < times; ++i) {
    const std::string text = (fuzzer.*make)();
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(complaint(text), "") << "seed " << seed << ", text:\n" << text;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    ASSERT_LT(taken.count(), 30.0) << "seed " << seed << ", text:\n" << text;  // 2^26 tuples under `where` take 8 s
  }
}

}  // namespace

TEST(SpecFuzz, SeedsAreValid) {
  for (const std::string& text : seeds) EXPECT_NO_THROW(Sweep::parse(text, "fuzz.toml", study_sections));
}
TEST(SpecFuzz, MutatedSpecs) { run(&Fuzzer::mutated, 4000); }
TEST(SpecFuzz, RandomBytesAndTokens) { run(&Fuzzer::random, 4000); }
TEST(SpecFuzz, RandomConditions) { run(&Fuzzer::random_where, 4000); }
