#include "sigmasweep/plot/plot.hpp"

#include <gtest/gtest.h>

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include "plot/figure/figure.hpp"
#include "plot/gnuplot/script.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

Row make_row(Method method, double v0, double tc, double sigma, double eps_eff, Status status = Status::ok) {
  Row row;
  row.parameters.method = method;
  row.parameters.v0 = v0;
  row.parameters.tc = tc;
  row.parameters.sigma = sigma;
  row.result.eps_eff = eps_eff;
  row.result.status = status;
  return row;
}

PlotSpec by_pair() {
  PlotSpec spec;
  spec.series = {"v0", "tc"};
  return spec;
}

std::size_t points(const plot::Figure& figure) {
  std::size_t n = 0;
  for (const auto& curve : figure.curves) n += curve.line ? curve.path.size() : curve.points.size();
  return n;
}

TEST(PlotFigure, HardSpheresAreOneLineWhateverTheSeries) {
  const std::vector<Row> rows{make_row(Method::md, 1, 1e-5, 0.1, 0.9), make_row(Method::md, 2, 1e-5, 0.2, 0.8),
                              make_row(Method::ed, 1, 1e-5, 0.2, 0.3), make_row(Method::ed, 2, 1e-5, 0.1, 0.3)};
  const auto figure = plot::figure_of(rows, by_pair(), "title");
  ASSERT_EQ(figure.curves.size(), 3u);
  EXPECT_FALSE(figure.curves[0].line);
  EXPECT_EQ(figure.curves[1].label, "{/:Italic v}_0 = 2 m/s, {/:Italic t}_c = 10^{-5} s");
  EXPECT_TRUE(figure.curves[2].line);
  EXPECT_EQ(figure.curves[2].label, "ED (LRV)");
  ASSERT_EQ(figure.curves[2].path.size(), 2u);
  EXPECT_LT(figure.curves[2].path[0].x, figure.curves[2].path[1].x);  // a line goes from left to right
  EXPECT_EQ(figure.note, "");
  EXPECT_EQ(figure.title, "title");
}

TEST(PlotFigure, KeysHaveWordsForNames) {
  std::vector<Row> rows{make_row(Method::md, 1, 1e-5, 0.1, 0.9), make_row(Method::md, 1, 1e-5, 0.1, 0.8)};
  rows[1].parameters.law = Law::hertz_kuwabara_kono;
  rows[1].parameters.random_separation = Flag::yes;
  PlotSpec spec;
  spec.series = {"law", "random_separation", "wall"};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  EXPECT_EQ(figure.curves[0].label, "Hooke, equal gaps, wall paper");
  EXPECT_EQ(figure.curves[1].label, "Hertz-Kuwabara-Kono, random gaps, wall paper");
}

TEST(PlotFigure, CountsWhatCannotBeDrawn) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Row> rows{
      make_row(Method::md, 1, 1e-5, 0.1, 0.9), make_row(Method::md, 1, 1e-5, 0.0, 0.9),
      make_row(Method::md, 1, 1e-5, 0.0, 0.9), make_row(Method::md, 1, 1e-5, 0.3, nan, Status::time_limit),
      make_row(Method::md, 1, 1e-5, 0.4, nan), make_row(Method::ed, 1, 1e-5, 0.4, 0.0, Status::collapsed)};  // a result
  auto figure = plot::figure_of(rows, by_pair(), "");
  EXPECT_EQ(points(figure), 2u);
  EXPECT_EQ(figure.note,
            "Not drawn: 1 row that failed; 2 rows with {/:Italic σ} ≤ 0 (logarithmic axis); "
            "1 row without a finite value");
  PlotSpec linear = by_pair();
  linear.x_log = false;
  figure = plot::figure_of(rows, linear, "");
  EXPECT_EQ(figure.note, "Not drawn: 1 row that failed; 1 row without a finite value");
}

TEST(PlotFigure, EveryCurveStaysVisibleWhereAllFallOnOne) {
  std::vector<Row> rows;
  for (int curve = 0; curve < 4; ++curve)
    for (int k = 0; k < 2000; ++k) rows.push_back(make_row(Method::md, 1 + curve, 1e-5, 1e-3 + k, 0.5));
  rows.push_back(make_row(Method::md, 1, 1e-5, 250.0, 0.7));  // one that is elsewhere is always drawn
  PlotSpec spec = by_pair();
  spec.x_log = false;
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 4u);
  for (const auto& curve : figure.curves) EXPECT_GT(curve.points.size(), 15u);
  EXPECT_LT(points(figure), 200u);
  const auto& first = figure.curves[0].points;
  EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const plot::Point& p) { return p.y == 0.7; }));
}

TEST(PlotFigure, CurvesOnOneLineTakeTurnsInFront) {
  std::vector<Row> rows;
  for (int curve = 0; curve < 4; ++curve)
    for (int k = 0; k < 500; ++k) rows.push_back(make_row(Method::md, 1 + curve, 1e-5, 1e-3 + k, 0.5));
  rows.push_back(make_row(Method::md, 1, 1e-5, 250.0, 0.7));  // alone in its place
  PlotSpec spec = by_pair();
  spec.x_log = false;
  const plot::Figure figure = plot::figure_of(rows, spec, "");
  EXPECT_EQ(points(figure), 2001u);
  for (const auto& curve : figure.curves) {
    EXPECT_GT(curve.front.size(), 15u);
    EXPECT_LT(curve.front.size(), 50u);
    EXPECT_TRUE(std::ranges::all_of(curve.front, [](const plot::Point& p) { return p.y == 0.5; }));
  }
}

TEST(PlotFigure, DrawsThousandsOfSymbolsAndSaysHowManyItLeavesOut) {
  std::vector<Row> rows;
  for (int k = 0; k < 5000; ++k) rows.push_back(make_row(Method::md, 1, 1e-5, 0.1 + 1e-6 * k, 0.9));
  const plot::Figure all = plot::figure_of(rows, by_pair(), "");
  EXPECT_EQ(points(all), 5000u);
  EXPECT_EQ(all.note, "");
  rows.push_back(make_row(Method::md, 1, 1e-5, 0.2, 0.9));
  const plot::Figure thinned = plot::figure_of(rows, by_pair(), "");
  EXPECT_LT(points(thinned), 200u);
  EXPECT_EQ(thinned.note,
            std::to_string(points(thinned)) + " of 5001 symbols are drawn, the others are at the same places");
}

/// Elastic spheres give all energy back, but for rounding.
TEST(PlotFigure, AxesDoNotShowRounding) {
  for (const bool log : {false, true}) {
    PlotSpec spec = by_pair();
    spec.y_log = log;
    const double below = std::nextafter(1.0, 0.0);
    const std::vector<Row> rows{make_row(Method::md, 1, 1e-5, 0.1, 1.0), make_row(Method::md, 1, 1e-5, 0.2, below)};
    const plot::Figure figure = plot::figure_of(rows, spec, "");
    EXPECT_LT(figure.y.from, 0.6);
    EXPECT_GT(figure.y.to, 1.4);
    EXPECT_LT(plot::gnuplot_script(figure, plot::Form::svg).size(), 5000u);
  }
}

TEST(PlotFigure, RefusesFieldsThatAreNoNumbers) {
  PlotSpec spec;
  spec.x = "sigm";
  EXPECT_THROW(plot::figure_of({}, spec, ""), UsageError);
  spec.x = "method";
  EXPECT_THROW(plot::figure_of({}, spec, ""), UsageError);
  spec = by_pair();
  spec.series = {"colour"};
  EXPECT_THROW(plot::figure_of({}, spec, ""), UsageError);
}

TEST(PlotLabels, NumbersAsPeopleWriteThem) {
  EXPECT_EQ(plot::pretty(14.0), "14");
  EXPECT_EQ(plot::pretty(2.5e-6), "2.5×10^{-6}");
  EXPECT_EQ(plot::pretty(1e-4), "10^{-4}");
  EXPECT_EQ(plot::pretty(0.0022), "0.0022");
  EXPECT_EQ(plot::pretty(0.0), "0");
  EXPECT_EQ(plot::pretty(-2e-9), "-2×10^{-9}");
  EXPECT_EQ(plot::axis_label(*find_field("tc")), "{/:Italic t}_c (s)");
  EXPECT_EQ(plot::escape_markup("a_b^{c}@d"), "a\\_b\\^\\{c\\}\\@d");
}

TEST(PlotScript, UserTextStaysText) {
  plot::Figure figure;
  figure.title = "it's\n'; system 'touch pwned'; # `touch pwned` \\";
  const std::string script = plot::gnuplot_script(figure, plot::Form::svg);
  EXPECT_NE(
      script.find(R"(set title "it\047s \047; system \047touch pwned\047; # \140touch pwned\140 \134" noenhanced)"),
      std::string::npos)
      << script;
}

TEST(PlotScript, NamesOfFontsInLabelsAreNames) {
  plot::Figure figure;
  figure.x.label = R"({/F"><script>alert(1)</script> x} {/Times-Italic=20 y} a < b)";
  const std::string script = plot::gnuplot_script(figure, plot::Form::svg);
  EXPECT_NE(script.find(R"(set xlabel "{/Fscriptalert1script x} {/Times-Italic=20 y} a < b")"), std::string::npos)
      << script;
}

TEST(PlotScript, FormFollowsTheEnding) {
  EXPECT_EQ(plot::form_of("a.b/c.svg"), plot::Form::svg);
  EXPECT_EQ(plot::form_of("c.png"), plot::Form::png);
  EXPECT_EQ(plot::form_of("c.pdf"), plot::Form::pdf);
  EXPECT_THROW(plot::form_of("svg"), UsageError);
  EXPECT_THROW(plot::form_of("c.h5"), UsageError);
}

class PlotRows : public testing::Test {
 protected:
  PlotRows() { std::filesystem::create_directories(directory_); }
  ~PlotRows() override { std::filesystem::remove_all(directory_); }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  static std::string read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::filesystem::path directory_ =
      std::filesystem::temp_directory_path() / ("sigmasweep plot " + std::to_string(::getpid()));
};

TEST_F(PlotRows, DrawsAllForms) {
  const std::vector<Row> rows{make_row(Method::md, 1, 1e-5, 0.1, 0.9), make_row(Method::md, 1, 1e-5, 1, 0.5),
                              make_row(Method::ed, 1, 1e-5, 0.1, 0.3), make_row(Method::ed, 1, 1e-5, 1, 0.3)};
  plot_rows(rows, by_pair(), "Title", path("a b.svg"));
  plot_rows(rows, by_pair(), "Title", path("a.png"));
  plot_rows(rows, by_pair(), "Title", path("a.pdf"));
  const std::string svg = read(path("a b.svg"));
  for (const char* word : {"<svg", "Title", "ED (LRV)", "effective restitution", "stroke-dasharray"})
    EXPECT_NE(svg.find(word), std::string::npos) << word;
  EXPECT_TRUE(read(path("a.png")).starts_with("\x89PNG"));
  EXPECT_TRUE(read(path("a.pdf")).starts_with("%PDF"));
}

TEST_F(PlotRows, NothingToDrawIsAPictureThatSaysSo) {
  const std::vector<Row> rows{make_row(Method::md, 1, 1e-5, 0.0, 0.9)};
  plot_rows(rows, by_pair(), "", path("empty.svg"));
  EXPECT_NE(read(path("empty.svg")).find("1 row with"), std::string::npos);
  plot_rows({}, by_pair(), "", path("none.svg"));
  EXPECT_NE(read(path("none.svg")).find("<svg"), std::string::npos);
}

TEST_F(PlotRows, SaysWhenItCannotWrite) {
  EXPECT_THROW(plot_rows({}, by_pair(), "", path("missing/a.svg")), OutputError);
  EXPECT_THROW(plot_rows({}, by_pair(), "", path("a.gif")), UsageError);
  EXPECT_TRUE(std::filesystem::is_empty(directory_));
}

}  // namespace
}  // namespace sigmasweep
