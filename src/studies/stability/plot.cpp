#include "studies/stability/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "plot/gnuplot/gnuplot.hpp"
#include "plot/labels.hpp"
#include "plot/range.hpp"
#include "sigmasweep/base/errors.hpp"
#include "studies/stability/map.hpp"

namespace sigmasweep {
namespace {

using namespace plot;

struct Look {
  Observed observed;
  int point;
  std::string_view size, colour, meaning;
};
constexpr auto looks = std::to_array<Look>({
    {Observed::good, 5, "1.0", "#009E73", "off by < 1 %"},
    {Observed::fair, 5, "1.0", "#E6C700", "< 10 %"},
    {Observed::wrong, 5, "1.0", "#CC79A7", "more"},
    {Observed::unstable, 2, "1.0", "#C03000", "unstable"},
    {Observed::nothing, 1, "0.6", "#808080", "no result"},
});

std::string style_of(const Look& look) {
  return fmt::format("points pointtype {} pointsize {} linewidth 1.5 linecolor '{}'", look.point, look.size,
                     look.colour);
}
constexpr std::string_view limit_style = "lines linewidth 2 linecolor '#000000'";

std::string points_of(const StabilityMap& map, Observed observed) {
  std::string out;
  for (const StabilityCell& cell : map.cells)
    if (cell.observed == observed) out += fmt::format("{:.9g} {:.9g}\n", 1.0 / cell.steps, cell.y);
  return out.empty() ? "NaN NaN\n" : out;
}

std::string map_script(const StabilityMap& map, std::size_t number) {
  std::string data, plots;
  for (const Look& look : looks) {
    const std::string block = fmt::format("$m{}_{}", number, static_cast<int>(look.observed));
    data += block + " << end_of_data\n" + points_of(map, look.observed) + "end_of_data\n";
    plots += fmt::format("{} {} using 1:2 with {}", plots.empty() ? "plot" : ",", block, style_of(look));
  }
  const std::string block = fmt::format("$l{}", number);
  data += block + " << end_of_data\n";
  for (const StabilityLimit& limit : map.limits) data += fmt::format("{:.9g} {:.9g}\n", 1.0 / limit.steps, limit.y);
  data += "end_of_data\n";
  return data + fmt::format("set title '{}'\n{}, {} using 1:2 with {}\n", map.label, plots, block, limit_style);
}

/// The key of all maps, as the key of an empty plot below them.
std::string key_script() {
  std::string plots;
  for (const Look& look : looks)
    plots += fmt::format("{} NaN with {} title '{}'", plots.empty() ? "plot [0:1] [0:1]" : ",", style_of(look),
                         look.meaning);
  return "unset logscale\nunset title\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid\n"
         "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen 0\nset tmargin at screen 0.04\n"
         "set key at screen 0.5,0.01 center bottom horizontal samplen 1.5\n" +
         fmt::format("{}, NaN with {} title 'predicted limit'\n", plots, limit_style);
}

/// The maps on common axes.
std::string axes_script(std::span<const StabilityMap> maps, bool y_log) {
  Range steps, values;
  for (const StabilityMap& map : maps)
    for (const StabilityCell& cell : map.cells) {
      steps.include(1.0 / cell.steps);
      values.include(cell.y);
    }
  const double room = 0.06 * std::max(values.high - values.low, 1e-3 * values.high);
  const double low = y_log ? values.low / 1.2 : values.low - room;
  const double high = y_log ? values.high * 1.2 : values.high + room;
  return fmt::format(
      "set logscale {}\nset xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset xlabel 'dt/t_c'\n"
      "set format x '%g'\nset format y '%g'\n",
      y_log ? "xy" : "x", steps.low / 1.2, 1.2 * steps.high, low, high);
}

/// Number of panels in a line: the number of maps with the same first axis, if they fit.
std::size_t columns_for(std::span<const StabilityMap> maps) {
  const auto first = [](const StabilityMap& map) { return map.plain_label.substr(0, map.plain_label.find(',')); };
  const auto same = std::size_t(
      std::ranges::count_if(maps, [&](const StabilityMap& map) { return first(map) == first(maps.front()); }));
  return same > 1 && same <= 8 && maps.size() % same == 0 ? same : std::min<std::size_t>(maps.size(), 4);
}

}  // namespace

void plot_stability(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes,
                    const std::string& title, const std::string& path) {
  const Form form = form_of(path);
  const auto maps = stability_maps(rows, plot, axes);
  if (maps.size() > max_stability_maps)
    throw UsageError(fmt::format("plot: {} maps, but at most {} find room on a picture: choose with 'where' in [plot]",
                                 maps.size(), max_stability_maps));
  const std::size_t columns = columns_for(maps), lines = (maps.size() + columns - 1) / columns;
  const double x = std::max(double(columns), 2.0), y = double(lines);
  std::string script =
      fmt::format("set encoding utf8\nset terminal {}\n", panels_terminal(form, 90.0 + 270.0 * x, 110.0 + 240.0 * y));
  script += fmt::format(
      "set multiplot layout {},{} rowsfirst title {} noenhanced margins screen {:.3f},0.98,{:.3f},{:.3f} "
      "spacing screen {:.3f},{:.3f}\n",
      lines, columns, quoted(plot.title.empty() ? title : plot.title), 0.22 / (x + 0.35), 0.48 / (y + 0.45),
      1.0 - 0.36 / (y + 0.45), 0.16 / x, 0.30 / y);
  script +=
      "set border 3 linecolor '#404040'\nset tics nomirror out\nset grid linetype 1 linecolor '#E4E4E4' "
      "linewidth 0.6\nunset key\n" +
      axes_script(maps, plot.y_log);
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (k % columns == 1) script += "set ylabel ''\n";
    if (k % columns == 0) script += fmt::format("set ylabel {}\n", quoted(symbol_of(stability_axis(plot))));
    script += map_script(maps[k], k);
  }
  run_gnuplot(script + key_script() + "unset multiplot\n", path);
}

}  // namespace sigmasweep
