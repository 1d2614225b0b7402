#include "sweep/spec/with_settings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sigmasweep/base/errors.hpp"

using namespace sigmasweep;

namespace {

/// The text of the spec with one setting, without the note at its end.
std::string set(const std::string& text, const std::string& setting) {
  const std::string changed = spec::with_settings(text, std::vector{setting});
  return changed.substr(0, changed.rfind("# set on the command line: "));
}

/// The value that [sweep] is given in the place of 10.
std::string value(const std::string& typed) {
  const std::string text = set("[sweep]\nN = 10\n", "N=" + typed), before = "[sweep]\nN = ";
  EXPECT_TRUE(text.starts_with(before)) << text;
  return text.substr(before.size(), text.size() - before.size() - 1);
}

std::string refusal(const std::string& setting, const std::string& text = "[sweep]\nN = 10\n") {
  try {
    spec::with_settings(text, std::vector{setting});
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST(WithSettings, ReplacesTheValueAndKeepsAllElse) {
  EXPECT_EQ(set("# beads\n[sweep]\nN = 10  # many\nv0 = 1.0\n", "N=20"),
            "# beads\n[sweep]\nN = 20  # many\nv0 = 1.0\n");
  EXPECT_EQ(set("[sweep]\nv0 = [1.0, # m/s\n  2.0]\nN = 3\n", "v0=[5]"), "[sweep]\nv0 = [5]\nN = 3\n");
  EXPECT_EQ(set("title = \"\u03c3\"\n[sweep]\nwhere = \"N > 1\" # \u03c3\n", "where='N > 2'"),
            "title = \"\u03c3\"\n[sweep]\nwhere = 'N > 2' # \u03c3\n");
  EXPECT_EQ(set("sweep = { N = 1, law = \"\u03c3\", v0 = 3 }", "v0=4"),
            "sweep = { N = 1, law = \"\u03c3\", v0 = 4 }\n");
  EXPECT_EQ(set("[sweep]\r\nN = 10\r\nv0 = 1\r\n", "v0=2"), "[sweep]\r\nN = 10\r\nv0 = 2\r\n");
  EXPECT_EQ(set("[sweep]\ns0 = { from = 1, to = 2, count = 3 }\n", "s0=4"), "[sweep]\ns0 = 4\n");
}

TEST(WithSettings, NewKeysComeBehindTheOthers) {
  EXPECT_EQ(set("[sweep]\nN = 1 # few\n\n[plot]\nx = \"N\"\n", "v0=3"),
            "[sweep]\nN = 1 # few\nv0 = 3\n\n[plot]\nx = \"N\"\n");
  EXPECT_EQ(set("[sweep] # empty", "v0=3"), "[sweep] # empty\nv0 = 3\n");
  EXPECT_EQ(set("sweep = { N = 1 }\n", "v0=3"), "sweep = { N = 1 , v0 = 3}\n");
  EXPECT_EQ(set("sweep = {}\n", "v0=3"), "sweep = {v0 = 3}\n");
  EXPECT_EQ(set("sweep.N = 1\nsweep.tc = 1\n", "v0=3"), "sweep.N = 1\nsweep.tc = 1\nsweep.v0 = 3\n");
}

TEST(WithSettings, NamesAndConditionsNeedNoQuotes) {
  EXPECT_EQ(value("20"), "20");
  EXPECT_EQ(value(" 2e-5 # small"), "2e-5");
  EXPECT_EQ(value("ed"), "\"ed\"");
  EXPECT_EQ(value("\"ed\""), "\"ed\"");
  EXPECT_EQ(value("true"), "true");
  EXPECT_EQ(value("[md, 'ed']"), "[\"md\", 'ed']");
  EXPECT_EQ(value("[hertz-kuwabara-kono, power]"), "[\"hertz-kuwabara-kono\", \"power\"]");
  EXPECT_EQ(value("{from=1e-3, to=1.5e+2, count=3, scale=log}"), "{from=1e-3, to=1.5e+2, count=3, scale=\"log\"}");
  EXPECT_EQ(value("{sample=log-uniform, from=-1, to=inf}"), "{sample=\"log-uniform\", from=-1, to=inf}");
  EXPECT_EQ(set("[sweep]\nwhere = \"\"\n", "where=N == 3 && v0 < 1"), "[sweep]\nwhere = 'N == 3 && v0 < 1'\n");
}

TEST(WithSettings, SayWhatWasSet) {
  const std::vector<std::string> settings{"N=2", "v0=[1, 2]", "N=3"};
  EXPECT_EQ(spec::with_settings("[sweep]\nN = 1\nv0 = 1", settings),
            "[sweep]\nN = 3\nv0 = [1, 2]\n# set on the command line: N = 2\n"
            "# set on the command line: v0 = [1, 2]\n# set on the command line: N = 3\n");
  EXPECT_EQ(spec::with_settings("[sweep]\nN = 1", {}), "[sweep]\nN = 1");
}

TEST(WithSettings, OtherFormsAreRefused) {
  EXPECT_EQ(refusal("N"), "--set N: give KEY=VALUE, such as --set N=20");
  EXPECT_EQ(refusal("=3"), "--set =3: give KEY=VALUE, such as --set N=20");
  EXPECT_EQ(refusal("a.b=3"), "--set a.b=3: give KEY=VALUE, such as --set N=20");
  EXPECT_EQ(refusal("tc=2*10^-5"), "--set tc=2*10^-5: '2*10^-5' is not a value in TOML (write 2e-5)");
  for (const char* wrong : {"N=", "N=[1", "N=1\nv0=2", "N=1, v0=2", "N='", "where=it's", "where=N > 1\nd = 1"})
    EXPECT_NE(refusal(wrong), "accepted") << wrong;
  EXPECT_NE(refusal("s0=1", "[sweep]\nN = 1\n[sweep.s0]\nfrom = 1\n"), "accepted");
}

TEST(WithSettings, TextsThatAreNoSpecsStayAsTheyAre) {
  for (const char* text : {"[sweep]\nN = = 1\n", "[sweep", "sweep = 3\n"}) EXPECT_EQ(set(text, "N=3"), text);
}
