#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plot/figure/figure.hpp"
#include "plot/gnuplot/script.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/plot/plot.hpp"

/// Expressions, fits, guides, averages and conditions in plots.
namespace sigmasweep {
namespace {

Row make_row(double sigma, double eps_eff, double v0 = 1.0, double epsilon = 0.9, Method method = Method::md) {
  Row row;
  row.parameters.sigma = sigma;
  row.parameters.v0 = v0;
  row.parameters.epsilon = epsilon;
  row.parameters.method = method;
  row.result.eps_eff = eps_eff;
  row.result.status = Status::ok;
  return row;
}

using Points = std::vector<plot::Point>;

TEST(PlotFit, LeastSquaresOfAWorkedExample) {
  // Anscombe's first data set (The American Statistician 27, 17 (1973)): 3.000 + 0.500 x, standard error 0.118.
  const Points points{{10, 8.04}, {8, 6.95}, {13, 7.58},  {9, 8.81}, {11, 8.33}, {14, 9.96},
                      {6, 7.24},  {4, 4.26}, {12, 10.84}, {7, 4.82}, {5, 5.68}};
  const auto fit = plot::fit(points, {.form = FitSpec::Form::line});
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->slope, 0.500, 0.5e-3);
  EXPECT_NEAR(fit->prefactor, 3.000, 0.5e-3);
  EXPECT_NEAR(fit->slope_error, 0.118, 0.5e-3);
  EXPECT_EQ(fit->points, 11u);
  EXPECT_EQ(fit->from, 4.0);
  EXPECT_EQ(fit->to, 14.0);
}

TEST(PlotFit, PowersWithinARange) {
  const Points points{{1, 100}, {10, 5}, {100, 0.5}, {1000, 0.05}, {0, 3}};
  const auto fit = plot::fit(points, {.form = FitSpec::Form::power, .from = 10, .to = 1000});
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->slope, -1.0, 1e-14);  // rounding of logarithms
  EXPECT_NEAR(fit->prefactor, 50.0, 1e-12);
  EXPECT_LT(fit->slope_error, 1e-14);
  EXPECT_EQ(fit->points, 3u);
  EXPECT_NEAR((*fit)(20.0), 2.5, 1e-13);
  const Points edge{{1 - 0.99, 1}, {1 - 0.9, 10}};
  const auto two = plot::fit(edge, {.form = FitSpec::Form::power, .from = 0.01, .to = 0.1});
  ASSERT_TRUE(two.has_value());  // ends included, whatever 1 - 0.99 is in binary
  EXPECT_TRUE(std::isnan(two->slope_error));
}

TEST(PlotFit, NeedsTwoPlaces) {
  EXPECT_FALSE(plot::fit({}, {}).has_value());
  EXPECT_FALSE(plot::fit({{1, 2}}, {}).has_value());
  EXPECT_FALSE(plot::fit({{1, 2}, {1, 3}}, {}).has_value());
  EXPECT_FALSE(plot::fit({{1, 2}, {2, -3}}, {}).has_value());  // no logarithm
}

TEST(PlotFit, NumbersWithTheirErrors) {
  EXPECT_EQ(plot::with_error(-0.4634, 0.0032), "−0.463 ± 0.003");
  EXPECT_EQ(plot::with_error(0.9467, 0.0133), "0.947 ± 0.013");
  EXPECT_EQ(plot::with_error(123.4, 25.0), "123 ± 25");
  EXPECT_EQ(plot::with_error(2.0, 1e-16), "2");
  EXPECT_EQ(plot::with_error(-0.5, std::nan("")), "−0.5");
}

TEST(PlotFigureFit, GoesToTheKeyAndTheTable) {
  std::vector<Row> rows;
  for (const double sigma : {1.0, 2.0, 4.0, 8.0}) {
    rows.push_back(make_row(sigma, 1 - 0.1 * sigma * sigma / 64, 1.0, 0.6));
    if (sigma == 1.0) rows.push_back(make_row(sigma, 0.5, 1.0, 0.9));
  }
  PlotSpec spec;
  spec.y = "1 - eps_eff";
  spec.y_log = true;
  spec.series = {"epsilon"};
  spec.fit = FitSpec{};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  EXPECT_EQ(figure.curves[0].label, "{/:Italic ε} = 0.6: slope 2");
  EXPECT_EQ(figure.curves[1].label, "{/:Italic ε} = 0.9");
  EXPECT_EQ(figure.note, "no fit for epsilon = 0.9: fewer than two points in the range");
  EXPECT_EQ(figure.y.label, "1 − {/:Italic ε}_{eff}");
  const std::vector<SeriesFit> fits{{"epsilon = 0.6", -0.4634, 0.0032, 0.308139, 4}};
  EXPECT_EQ(fit_table(fits, *spec.fit),
            "  series                slope      error     prefactor  points\n"
            "  epsilon = 0.6       -0.4634     0.0032      0.308139       4\n");
  EXPECT_EQ(fit_table({}, *spec.fit), "");
}

TEST(PlotFigure, OnlyTheRowsThatAreAskedFor) {
  const std::vector<Row> rows{make_row(0.1, 0.9), make_row(1.0, 0.5), make_row(10.0, 0.3)};
  PlotSpec spec;
  spec.where = "sigma >= 1";
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 1u);
  EXPECT_EQ(figure.curves[0].points.size(), 2u);
  EXPECT_EQ(figure.note, "");
  spec.where = "sigma";
  EXPECT_THROW(plot::figure_of(rows, spec, ""), UsageError);
}

TEST(PlotFigure, MeansWithTheirDeviation) {
  std::vector<Row> rows;
  for (const double v0 : {1.0, 2.0, 3.0})
    for (const double epsilon : {0.6, 0.9}) rows.push_back(make_row(0.1, 0.1 * v0 + epsilon / 2, v0, epsilon));
  rows.push_back(make_row(1.0, 0.5, 1.0, 0.6));
  PlotSpec spec;
  spec.series = {"epsilon"};
  spec.mean_over = {"v0"};
  auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  ASSERT_EQ(figure.curves[1].points.size(), 1u);
  EXPECT_NEAR(figure.curves[1].points[0].y, 0.65, 1e-15);
  EXPECT_NEAR(figure.curves[1].points[0].deviation, 0.1, 1e-15);  // of 0.55, 0.65, 0.75
  EXPECT_EQ(figure.note, "Means over {/:Italic v}_0, n = 1 to 3, bars: standard deviation");
  // epsilon neither in the series nor averaged over: rows that differ in it are not mixed.
  spec.series.clear();
  figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 1u);
  EXPECT_EQ(figure.curves[0].points.size(), 3u);
  for (const auto& p : figure.curves[0].points) EXPECT_NEAR(p.deviation, p.x > 0.5 ? 0.0 : 0.1, 1e-15);
}

TEST(PlotFigure, MeansOfHardSpheresToo) {
  std::vector<Row> rows;
  for (const Method method : {Method::md, Method::ed})
    for (const double epsilon : {0.6, 0.8}) rows.push_back(make_row(0.1, epsilon, 1.0, epsilon, method));
  PlotSpec spec;
  spec.mean_over = {"epsilon"};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  ASSERT_EQ(figure.curves[1].path.size(), 1u);
  EXPECT_NEAR(figure.curves[1].path[0].y, 0.7, 1e-15);
}

TEST(PlotScript, ShortLogarithmicAxesHaveLabels) {
  plot::Figure figure;
  figure.x = {.label = "", .log = true, .from = 1.8, .to = 22.0};
  EXPECT_NE(plot::gnuplot_script(figure, plot::Form::svg).find(R"(set xtics ("2" 2, "5" 5, "10" 10, "20" 20))"),
            std::string::npos);
  figure.x = {.label = "", .log = true, .from = 3.1, .to = 4.05};
  EXPECT_NE(plot::gnuplot_script(figure, plot::Form::svg).find(R"(set xtics ("3.2" )"), std::string::npos);
}

Row vibrated(double alpha, double excess, double error, Method method = Method::md) {
  Row row;
  row.parameters.geometry = Geometry::vibrated_column;
  row.parameters.alpha = alpha;
  row.parameters.method = method;
  row.result.vibration.h_cm_excess = excess;
  row.result.vibration.h_cm_error = error;
  row.result.status = Status::ok;
  return row;
}

TEST(PlotFigure, GuidesMayBeExpressionsOfX) {
  const std::vector<Row> rows{vibrated(1.0, 1e-3, 1e-5), vibrated(20.0, 0.3, 1e-3)};
  PlotSpec spec;
  spec.x = "alpha";
  spec.y = "h_cm_excess";
  spec.x_log = false;
  spec.guides = {{.label = "square", .curve = "0.5e-3*x^2", .from = 2.0}, {.label = "root", .curve = "sqrt(x - 30)"}};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.guides.size(), 2u);
  const auto& square = figure.guides[0].path;
  ASSERT_GT(square.size(), 100u);
  EXPECT_NEAR(square.front().x, 2.0, 1e-14);  // rounding of the way along the axis and back
  EXPECT_NEAR(square.back().x, figure.x.to, 1e-14);
  for (const plot::Point& point : square) EXPECT_NEAR(point.y, 0.5e-3 * point.x * point.x, 1e-16);
  EXPECT_TRUE(figure.guides[1].path.empty());  // nowhere a number
  EXPECT_NE(plot::gnuplot_script(figure, plot::Form::svg).find("title \"square\""), std::string::npos);
  spec.guides = {{.label = "bad", .curve = "0.5*alpha"}};
  EXPECT_THROW(plot::figure_of(rows, spec, ""), UsageError);
}

TEST(PlotFigure, HeightsHaveErrorBars) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Row> rows{vibrated(2.0, 1e-3, 1e-5), vibrated(4.0, 2e-3, nan),
                              vibrated(4.0, 3e-3, 3e-5, Method::ed)};
  PlotSpec spec;
  spec.x = "alpha";
  spec.y = "h_cm_excess";
  spec.x_log = false;
  spec.series = {"method"};
  auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  EXPECT_FALSE(figure.curves[1].line);  // hard spheres as symbols, with bars
  ASSERT_EQ(figure.curves[0].points.size(), 2u);
  EXPECT_EQ(figure.curves[0].points[0].deviation, 1e-5);
  EXPECT_EQ(figure.curves[0].points[1].deviation, 0.0);  // unknown
  EXPECT_EQ(figure.curves[1].points.at(0).deviation, 3e-5);
  EXPECT_NE(plot::gnuplot_script(figure, plot::Form::svg).find("with yerrorbars"), std::string::npos);
  spec.y = "1000*h_cm_excess";
  EXPECT_TRUE(plot::figure_of(rows, spec, "").curves[1].line);
  spec.y_error = "1000*h_cm_error";
  figure = plot::figure_of(rows, spec, "");
  EXPECT_DOUBLE_EQ(figure.curves[0].points[0].deviation, 1e-2);
}

TEST(PlotFigure, GuidesThroughAPointAndThroughTheEndOfASeries) {
  std::vector<Row> rows;
  for (const double sigma : {1.0, 10.0, 100.0}) rows.push_back(make_row(sigma, 0.5 / sigma));
  PlotSpec spec;
  spec.y_log = true;
  spec.guides = {{.label = "a", .slope = 1.0, .through = std::array{1.0, 0.25}, .from = 2.0, .to = 4.0},
                 {.label = "b", .slope = -0.5, .where = "sigma < 50"},
                 {.label = "c", .y = 0.01},
                 {.label = "d", .slope = 1.0, .where = "sigma > 1000"}};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.guides.size(), 3u);  // nothing to anchor d at
  EXPECT_NEAR(figure.guides[0].path.front().y, 0.5, 1e-15);
  EXPECT_NEAR(figure.guides[0].path.back().y, 1.0, 1e-15);
  const auto& b = figure.guides[1];
  EXPECT_NEAR(b.path.front().y * std::sqrt(b.path.front().x), 0.05 * std::sqrt(10.0), 1e-14);  // through (10, 0.05)
  EXPECT_EQ(b.path.back().x, figure.x.to);
  EXPECT_EQ(figure.guides[2].path.front().y, 0.01);
  EXPECT_EQ(figure.guides[2].path.back().y, 0.01);
  const std::string script = plot::gnuplot_script(figure, plot::Form::svg);
  for (const char* part : {"title \"a\"", "title \"b\"", "title \"c\"", "dashtype"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
}

TEST(PlotFigure, HardSpheresAloneAreSymbols) {
  const std::vector<Row> rows{make_row(0.1, 0.3, 1.0, 0.8, Method::ed), make_row(0.1, 0.4, 1.0, 0.9, Method::ed)};
  PlotSpec spec;
  spec.series = {"epsilon"};
  const auto figure = plot::figure_of(rows, spec, "");
  ASSERT_EQ(figure.curves.size(), 2u);
  EXPECT_FALSE(figure.curves[0].line);
  EXPECT_EQ(figure.curves[0].label, "{/:Italic ε} = 0.8");
  EXPECT_EQ(figure.curves[0].points.size(), 1u);
}

TEST(PlotFigure, JoinedPointsGoFromLeftToRight) {
  const std::vector<Row> rows{make_row(10, 0.3), make_row(0.1, 0.9), make_row(1, 0.5)};
  PlotSpec spec;
  spec.lines = true;
  const auto figure = plot::figure_of(rows, spec, "");
  EXPECT_EQ(figure.curves[0].path.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(figure.curves[0].path, {}, &plot::Point::x));
  EXPECT_EQ(figure.curves[0].points.size(), 3u);
}

TEST(PlotLabels, ExpressionsInSymbols) {
  EXPECT_EQ(plot::expression_label("1-eps_eff"), "1 − {/:Italic ε}_{eff}");
  EXPECT_EQ(plot::expression_label("N*tc"), "{/:Italic N}\u2009{/:Italic t}_c");
  EXPECT_EQ(plot::expression_label("(1 - eps_eff) / (1 - epsilon)"), "(1 − {/:Italic ε}_{eff})/(1 − {/:Italic ε})");
  EXPECT_EQ(plot::expression_label("-v0^2"), "−{/:Italic v}_0^{2}");
  EXPECT_EQ(plot::expression_label("log10(t_k)"), "log10({/:Italic t}_k)");
}

}  // namespace
}  // namespace sigmasweep
