#include "studies/precision/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "plot/gnuplot/gnuplot.hpp"
#include "plot/labels.hpp"
#include "plot/palette.hpp"
#include "plot/range.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/names.hpp"
#include "studies/precision/measure.hpp"

namespace sigmasweep {
namespace {

using namespace plot;

/// Half the last digit of a double between 1/2 and 1: smaller errors are drawn here.
constexpr double least_error = 0x1p-54;

struct Mark {
  double error, largest, time;  ///< NaN error: nothing to compare
  bool failed;
};
struct Series {
  std::string label;
  std::vector<Mark> marks;
};
struct Panel {
  std::string title;
  double noise = PrecisionRow::nan;
  std::vector<Series> series;
};

Series& series_named(Panel& panel, const std::string& label) {
  const auto found = std::ranges::find(panel.series, label, &Series::label);
  return found != panel.series.end() ? *found : panel.series.emplace_back(Series{label, {}});
}

/// The range of the numbers that a logarithmic axis can show.
struct Decades : Range {
  void include(double value) {
    if (value > 0.0 && std::isfinite(value)) Range::include(value);
  }
  /// Widens the range to whole decades, with a margin.
  void round() {
    if (is_empty()) low = high = 1.0;
    low = std::pow(10.0, std::floor(std::log10(low) - 0.1));
    high = std::pow(10.0, std::ceil(std::log10(high) + 0.1));
  }
};

/// The panels on common axes: failures stand at the right border, a decade beyond the largest error.
class Picture {
 public:
  Picture(std::span<const Panel> panels, std::string quantity) : quantity_(std::move(quantity)) {
    for (const Panel& panel : panels) {
      errors_.include(std::max(panel.noise, 1e-19));
      for (const Series& series : panel.series)
        for (const Mark& mark : series.marks) {
          times_.include(mark.time);
          if (std::isfinite(mark.error)) errors_.include(std::max(mark.error, least_error));
          if (std::isfinite(mark.error)) errors_.include(std::max(mark.largest, least_error));
        }
    }
    errors_.round();
    times_.round();
    errors_.high *= 10.0;
  }

  std::string axes() const {
    return fmt::format(
        "set logscale xy\nset format x '10^{{%L}}'\nset format y '10^{{%L}}'\nset xrange [{:g}:{:g}]\n"
        "set yrange [{:g}:{:g}]\nset xtics 1e3\nset xlabel 'error of {}: median, to largest'\n"
        "set ylabel 'CPU time a tuple (s)'\n",
        errors_.low, errors_.high, times_.low, times_.high, quantity_);
  }

  std::string panel(const Panel& panel, std::size_t number, bool key) const {
    std::string data, plots;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
      const Series& series = panel.series[i];
      const std::string block = fmt::format("$p{}_{}", number, i), colour(series_colour(i));
      data += block + " << end_of_data\n" + good(series) + "end_of_data\n";
      data += block + "f << end_of_data\n" + failed(series) + "end_of_data\n";
      const std::string title = key ? "title " + quoted(series.label) : "notitle";
      fmt::format_to(std::back_inserter(plots),
                     "{0} {1} using 1:3:1:2 with xerrorbars pointtype 0 linewidth 0.8 linecolor '{2}' notitle, "
                     "{1} using 1:3 with linespoints pointtype {3} pointsize 0.7 linewidth 1.3 linecolor '{2}' {4}, "
                     "{1}f using 1:2 with points pointtype 2 pointsize 1 linewidth 1.6 linecolor '{2}' notitle",
                     plots.empty() ? "plot" : ",", block, colour, series_symbol(i), title);
    }
    std::string noise = "unset arrow\n";
    if (panel.noise == panel.noise)
      noise += fmt::format("set arrow from {0:g},graph 0 to {0:g},graph 1 nohead dashtype (6,4) linecolor '#707070'\n",
                           std::max(panel.noise, errors_.low));
    return fmt::format("set title {}\n", quoted(panel.title)) + noise + data + plots + "\n";
  }

 private:
  std::string good(const Series& series) const {
    std::string out;
    for (const Mark& mark : series.marks)
      if (std::isfinite(mark.error) && mark.time > 0.0)
        out += fmt::format("{:.6g} {:.6g} {:.6g}\n", std::max(mark.error, least_error),
                           std::max(mark.largest, least_error), mark.time);
    return out.empty() ? "NaN NaN NaN\n" : out;
  }
  std::string failed(const Series& series) const {
    std::string out;
    for (const Mark& mark : series.marks)
      if (mark.failed && mark.time > 0.0) out += fmt::format("{:.6g} {:.6g}\n", errors_.high / 1.3, mark.time);
    return out.empty() ? "NaN NaN\n" : out;
  }

  Decades errors_, times_;
  std::string quantity_;
};

constexpr const char *eps_eff = "ε_{eff}", *height = "h_{cm}/A_0";

void draw(std::span<const Panel> panels, const std::string& quantity, const std::string& title,
          const std::string& path) {
  const Form form = form_of(path);
  std::size_t columns = 1;
  while (columns < 4 && columns * columns < panels.size()) ++columns;
  const std::size_t lines = (panels.size() + columns - 1) / columns;
  const Picture picture(panels, quantity);
  const bool single = panels.size() == 1;
  const double x = single ? 2.0 : double(columns), y = single ? 1.5 : double(lines);
  std::string script =
      fmt::format("set encoding utf8\nset terminal {}\n", panels_terminal(form, 100.0 + 340.0 * x, 90.0 + 300.0 * y));
  script += fmt::format("set multiplot layout {},{} rowsfirst title {} noenhanced\n", lines, columns, quoted(title));
  script +=
      "set border 3 linecolor '#404040'\nset tics nomirror out\nset key right top samplen 1.5 reverse Left\n"
      "set grid linetype 1 linecolor '#E4E4E4' linewidth 0.6\n" +
      picture.axes();
  for (std::size_t k = 0; k < panels.size(); ++k) script += picture.panel(panels[k], k, k == 0);
  run_gnuplot(script + "unset multiplot\n", path);
}

std::string panel_title(const PrecisionRow& row, std::span<const std::string> axes) {
  Row scene;
  scene.parameters = row.parameters;
  std::string title;
  for (const std::string& axis : axes)
    if (const Field* field = find_field(axis)) title += (title.empty() ? "" : ", ") + value_label(*field, scene);
  return row.chaotic > 0 ? title + " (chaotic)" : title;
}

}  // namespace

void plot_precision(std::span<const PrecisionRow> rows, std::span<const std::string> axes, const std::string& title,
                    const std::string& path) {
  std::vector<Panel> panels;
  const PrecisionRow* before = nullptr;
  for (const PrecisionRow& row : rows) {
    if (before == nullptr || before->scene != row.scene)
      panels.push_back({.title = panel_title(row, axes), .noise = row.noise, .series = {}});
    before = &row;
    if (row.tuples == 0) continue;
    series_named(panels.back(), std::string(name_of(row.parameters.integrator)))
        .marks.push_back({row.error_median, row.error_max, row.run_time, row.failures > 0});
  }
  if (panels.size() > max_precision_panels)
    throw UsageError(
        fmt::format("plot: {} scenes, but at most {} find room on a picture: choose with 'where' in "
                    "[plot]",
                    panels.size(), max_precision_panels));
  const auto vibrated =
      std::ranges::count_if(rows, [](const PrecisionRow& r) { return precision_quantity(r.parameters) == "h_cm/A0"; });
  const std::string both = fmt::format("{} (vibrated: {})", eps_eff, height);
  draw(panels, vibrated == 0 ? eps_eff : vibrated == std::ssize(rows) ? height : both, title, path);
}

void plot_precision_of(std::span<const Row> rows, const std::string& title, const std::string& path) {
  Panel panel;
  const auto differs = [&](auto member) {
    return std::ranges::any_of(
        rows, [&](const Row& row) { return row.parameters.*member != rows.front().parameters.*member; });
  };
  const bool steps = differs(&Parameters::steps_per_tc), tolerances = differs(&Parameters::tolerance);
  for (const Row& row : rows) {
    const Parameters& p = row.parameters;
    if (p.method != Method::md || row.timing.run_time <= 0.0) continue;
    std::string label(name_of(p.integrator));
    if (p.integrator == Integrator::exact && tolerances) label += ", " + value_label(*find_field("tolerance"), row);
    if (p.integrator != Integrator::exact && steps) label += fmt::format(", t_c/{:g}", p.steps_per_tc);
    const double error = row.result.eps_eff_error;
    series_named(panel, label).marks.push_back({error, error, row.timing.run_time, !is_success(row.result.status)});
  }
  if (panel.series.empty()) throw UsageError("plot: the table has no soft spheres that were computed and timed");
  panel.title = "error bars against run times of the rows";
  draw(std::span(&panel, 1), eps_eff, title, path);
}

}  // namespace sigmasweep
