#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "support/spec_refusal.hpp"
#include "sweep/expression/formula.hpp"
#include "sweep/expression/where.hpp"

/// [plot] and [[plot]] of a spec, and the formulas in them.
using namespace sigmasweep;

namespace {

/// `plots` begin on line 7.
std::string spec(const std::string& plots) {
  return "[sweep]\nv0 = 1.0\ntc = 1e-4\nN = 10\nepsilon = 0.9\nsigma = 1\n" + plots;
}
Sweep with(const std::string& plots) { return Sweep::parse(spec(plots), "plot.toml"); }

std::string refusal(const std::string& plots) { return refusal_of(spec(plots), "plot.toml"); }

Row sample_row() {
  Row row;
  row.parameters.N = 10;
  row.parameters.tc = 2e-5;
  row.parameters.epsilon = 0.75;
  row.parameters.ed_rule = EdRule::tc;
  row.result.eps_eff = 0.5;
  return row;
}

std::vector<Field> some_fields() {
  std::vector<Field> fields(parameter_fields().begin(), parameter_fields().end());
  fields.insert(fields.end(), result_fields().begin(), result_fields().end());
  return fields;
}

}  // namespace

TEST(Formula, CalculatesWithFields) {
  const auto value = [](const char* text) { return Formula(text, some_fields())(sample_row()); };
  EXPECT_EQ(value("eps_eff"), 0.5);
  EXPECT_EQ(value("(1 - eps_eff)/(1 - epsilon)"), 2.0);
  EXPECT_EQ(value("N*tc"), 10 * 2e-5);
  EXPECT_EQ(value("N^2"), 100.0);
  EXPECT_EQ(value("N > 5 ? 1 : 2"), 1.0);
  EXPECT_TRUE(std::isnan(value("t_k")));
  const auto used = Formula("N*tc/N", some_fields()).used();
  ASSERT_EQ(used.size(), 2u);
  EXPECT_EQ(used[0].name, "N");
  EXPECT_EQ(used[1].name, "tc");
}

TEST(Formula, RefusesWhatIsNoNumber) {
  const auto why = [](const char* text) -> std::string {
    try {
      Formula(text, some_fields());
    } catch (const UsageError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(why("N > 1"), "it must be a number, such as '1 - eps_eff'");
  EXPECT_EQ(why("method"), "it must be a number, such as '1 - eps_eff'");
  EXPECT_EQ(why("method + 1"), "only numbers can be calculated with");
  EXPECT_EQ(why("N, tc"), "it must be one expression, without ','");
  EXPECT_EQ(why("1 - eps_ef"), "unknown name 'eps_ef' (did you mean 'eps_eff'?)");
  EXPECT_NE(why(""), "accepted");
  EXPECT_NE(why("N *"), "accepted");
}

TEST(PlotSpec, HasEverything) {
  const Sweep sweep = with(R"toml([plot]
x = "N*tc"
y = "1 - eps_eff"
x_label = "a"
y_label = "b"
x_scale = "log"
y_scale = "log"
series = "epsilon"
where = "N > 1"
mean_over = ["v0", "s0"]
lines = true
fit = { form = "line", from = 10, to = 100 }
guides = [{ slope = -0.5, label = "c", through = [1, 2.5] }, { slope = 1, where = "N == 10", from = 3 }, { y = 0.3 }]
)toml");
  ASSERT_EQ(sweep.plots().size(), 1u);
  const PlotSpec& plot = sweep.plots()[0];
  EXPECT_EQ(plot.x + plot.x_label + plot.y + plot.y_label, "N*tca1 - eps_effb");
  EXPECT_TRUE(plot.x_log && plot.y_log && plot.lines);
  EXPECT_EQ(plot.series, std::vector<std::string>{"epsilon"});
  EXPECT_EQ(plot.mean_over, (std::vector<std::string>{"v0", "s0"}));
  EXPECT_EQ(plot.where, "N > 1");
  ASSERT_TRUE(plot.fit.has_value());
  EXPECT_EQ(plot.fit->form, FitSpec::Form::line);
  EXPECT_EQ(plot.fit->from, 10.0);
  EXPECT_EQ(plot.fit->to, 100.0);
  ASSERT_EQ(plot.guides.size(), 3u);
  EXPECT_EQ(plot.guides[0].slope, -0.5);
  EXPECT_EQ(plot.guides[0].through, (std::array{1.0, 2.5}));
  EXPECT_EQ(plot.guides[1].where, "N == 10");
  EXPECT_EQ(plot.guides[1].from, 3.0);
  EXPECT_EQ(plot.guides[1].to, std::numeric_limits<double>::infinity());
  EXPECT_EQ(plot.guides[2].y, 0.3);
}

TEST(PlotSpec, SeveralPlotsTheUnnamedFirst) {
  const auto named = with("[[plot]]\nname = \"a\"\n[[plot]]\nname = \"b\"\n").plots();
  ASSERT_EQ(named.size(), 2u);
  EXPECT_EQ(named[0].name, "a");
  const auto unnamed = with("[[plot]]\nname = \"a\"\n[[plot]]\nname = \"b\"\n[[plot]]\ny = \"t_k\"\n").plots();
  ASSERT_EQ(unnamed.size(), 3u);
  EXPECT_EQ(unnamed[0].y, "t_k");
  EXPECT_EQ(unnamed[1].name, "a");
  EXPECT_EQ(unnamed[2].name, "b");
  EXPECT_EQ(with("").plots().size(), 1u);
}

TEST(PlotSpec, Refusals) {
  const auto expect = [](const std::string& plots, const std::string& message) {
    EXPECT_EQ(refusal(plots), "plot.toml:" + message);
  };
  expect("[plot]\ny = \"1 - eps_ef\"", "8: plot.y = \"1 - eps_ef\": unknown name 'eps_ef' (did you mean 'eps_eff'?)");
  expect("[plot]\nx = \"N > 1\"", "8: plot.x = \"N > 1\": it must be a number, such as '1 - eps_eff'");
  expect("[plot]\nwhere = \"N + 1\"", "8: plot.where = \"N + 1\": it must be boolean, such as 'sigma > 1'");
  expect("[[plot]]\n[[plot]]\n", "8: plot: only one plot may be without a name");
  expect("[[plot]]\nname = \"a\"\n[[plot]]\nname = \"a\"", "9: plot: there is another plot 'a'");
  expect("[plot]\nname = \"../a\"", "8: plot.name = \"../a\": must be at most 60 letters, digits, '-' and '_'");
  expect("[plot]\nfit = { form = \"cubic\" }", "8: plot.fit.form = \"cubic\": must be 'power' or 'line'");
  expect("[plot]\nfit = { form = \"line\", from = 2, to = 1 }", "8: plot.fit: 'from' must be less than 'to'");
  expect("[plot]\nguides = [{ label = \"a\" }]", "8: plot.guides: a guide has either 'slope' or 'y'");
  expect("[plot]\nguides = [{ slope = 1 }]",
         "7: plot: a guide with a slope needs two logarithmic axes, or two linear ones");
  expect("[plot]\ny_scale = \"log\"\nguides = [{ slope = 1, through = [0, 1] }]",
         "7: plot: on logarithmic axes a guide must go through a point with x > 0 and y > 0");
  expect("[plot]\nguides = [{ slope = 1, through = [1] }]", "8: plot.guides.through = [...]: must be a point [x, y]");
  expect("[plot]\nlines = \"yes\"", "8: plot.lines = \"yes\": must be true or false");
  expect("[plot]\nmean_over = [\"seeed\"]",
         "8: plot.mean_over = \"seeed\": is no field of a row (did you mean "
         "'seed'?)");
  EXPECT_NE(refusal("plot = []"), "accepted");
}

TEST(WhereNames, MayBeThoseOfSomethingElseToo) {
  const auto holds = [](const char* text) { return Where(text, some_fields())(sample_row()); };
  EXPECT_TRUE(holds("ed_rule == tc && tc < 1"));  // tc is a field and a rule
  EXPECT_FALSE(holds("ed_rule==lrv || tc > 1"));
  EXPECT_TRUE(holds("end == none && material == none"));
  EXPECT_TRUE(holds("law != hertz-kuwabara-kono"));
  EXPECT_TRUE(holds("law == hooke && random_separation == false"));
  EXPECT_THROW(holds("law == hookee"), UsageError);
  EXPECT_THROW(holds("ed_rule == 1"), UsageError);
}
