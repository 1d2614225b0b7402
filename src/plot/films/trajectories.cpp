#include "plot/films/trajectories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>

#include "assembly/ground.hpp"
#include "plot/films/thin.hpp"
#include "plot/gnuplot/gnuplot.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

using namespace plot;

constexpr double invisible = 2e-4;  // of a panel's width: a tenth of a pixel

/// The prefix with which the largest number of an axis is between 1 and 1000.
struct Prefix {
  std::string_view name;
  double factor;
};
Prefix prefix_for(double largest) {
  static constexpr auto prefixes =
      std::to_array<Prefix>({{"", 1.0}, {"m", 1e-3}, {"µ", 1e-6}, {"n", 1e-9}, {"p", 1e-12}, {"f", 1e-15}});
  for (const Prefix& prefix : prefixes)
    if (largest >= prefix.factor) return prefix;
  return prefixes.front();
}

double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

/// The colour of a bead, from dark (the lowest) to light in steps of equal contrast: stops of matplotlib's viridis map.
std::string colour(std::size_t bead, std::size_t beads) {
  static constexpr std::array<std::array<double, 3>, 5> stops{
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {220, 200, 30}}};
  const double place = beads < 2 ? 0.0 : 4.0 * static_cast<double>(bead) / static_cast<double>(beads - 1);
  const auto stop = std::min<std::size_t>(static_cast<std::size_t>(place), 3);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(std::lerp(stops[stop][c], stops[stop + 1][c], place - static_cast<double>(stop)));
  return fmt::format("#{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2]);
}

/// Distance of the tics on an axis of this length: 1, 2 or 5 times a power of ten, for three to eight tics.
double step_of(double length) {
  const double most = length / 3.2, power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (5.0 * power <= most ? 5.0 : 2.0 * power <= most ? 2.0 : 1.0);
}

/// The number of the lowest or the top bead at the end of its line.
std::string bead_label(const Trajectory& t, std::size_t bead, Prefix height) {
  const double z = t.z[t.z.size() - t.beads() + bead] / height.factor;
  if (!std::isfinite(z)) return {};
  return fmt::format("set label '{}' at graph 1.02, first {:.6g} left textcolor '{}'\n", bead + 1, z,
                     colour(bead, t.beads()));
}

/// The horizontal axis: time, or for vibrated columns periods or the phase.
struct TimeAxis {
  std::string label;
  double unit;  ///< s
  bool is_phase;
  double width;  ///< in units
  double operator()(double t) const { return is_phase ? t / unit - std::floor(t / unit) : t / unit; }
};

TimeAxis time_axis(const Panel& panel, bool by_phase) {
  const Parameters& p = panel.row.parameters;
  const double longest = largest(panel.trajectory.time);
  if (!has_plate(panel)) {
    const Prefix prefix = prefix_for(longest);
    return {fmt::format("{{/:Italic t}} ({}s)", prefix.name), prefix.factor, false, longest / prefix.factor};
  }
  if (by_phase) return {"phase {/:Italic ωt}/2π", 1.0 / p.frequency, true, 1.0};
  return {"{/:Italic t} (periods)", 1.0 / p.frequency, false, longest * p.frequency};
}

/// The points of a line as gnuplot's data, with a gap where the line begins again at the left.
std::string line_data(std::span<const Point> points, double width, double range) {
  std::string out;
  for (std::size_t from = 0, to = 0; from < points.size(); from = to) {
    for (to = from + 1; to < points.size() && points[to].x >= points[to - 1].x;) ++to;
    const auto line = thinned(points.subspan(from, to - from), width, range, invisible);
    if (!out.empty() && !line.empty()) out += "\n";
    for (const Point& p : line) fmt::format_to(std::back_inserter(out), "{:.6g} {:.6g}\n", p.x, p.y);
  }
  return (out.empty() ? "NaN NaN\n" : out) + "end_of_line\n";
}

std::vector<Point> bead_line(const Trajectory& t, std::size_t bead, const TimeAxis& time, Prefix height) {
  std::vector<Point> points;
  for (std::size_t s = 0; s < t.samples(); ++s)
    points.push_back({time(t.time[s]), t.z[s * t.beads() + bead] / height.factor});
  return points;
}

std::vector<Point> plate_line(const Parameters& p, const TimeAxis& time, Prefix height) {
  constexpr int pieces = 100;  // a period
  const int all = static_cast<int>(std::min(std::ceil(pieces * time.width), 1e5));
  std::vector<Point> points;
  for (int k = 0; k <= all; ++k) {
    const double x = time.width * k / all;
    points.push_back({x, plate_height(p, x * time.unit) / height.factor});
  }
  return points;
}

std::string panel_script(const Panel& panel, std::size_t number, std::span<const std::string> differ, bool by_phase) {
  const Trajectory& t = panel.trajectory;
  const TimeAxis time = time_axis(panel, by_phase);
  const Prefix height = prefix_for(largest(t.z));
  const double width = time.width, range = std::max(largest(t.z) / height.factor, 1e-300);
  std::string out = fmt::format("set title {}\n", quoted(panel_title(number, panel.row, differ)));
  out += fmt::format("set xlabel '{}'\nset ylabel '{{/:Italic z_i}} ({}m)'\n", time.label, height.name);
  out += fmt::format("set xrange [0:{:.6g}]\nset xtics {:.6g}\n", width, step_of(width));
  const bool empty = std::ranges::none_of(t.z, [](double z) { return std::isfinite(z); });
  out += empty ? "set yrange [0:1]\n" : "set yrange [*:*]\n";  // gnuplot refuses an axis without a number
  std::string plots;
  if (has_plate(panel)) {
    out += fmt::format("$plate{} << end_of_line\n", number) +
           line_data(plate_line(panel.row.parameters, time, height), width, range);
    plots = fmt::format("plot $plate{} using 1:2 with lines linewidth 3 linecolor '#909090' notitle", number);
  }
  for (std::size_t bead = 0; bead < t.beads(); ++bead) {
    out += fmt::format("$panel{}_{} << end_of_line\n", number, bead) +
           line_data(bead_line(t, bead, time, height), width, range);
    plots += fmt::format("{} $panel{}_{} using 1:2 with lines linewidth 1.4 linecolor '{}' notitle",
                         plots.empty() ? "plot" : ",", number, bead, colour(bead, t.beads()));
  }
  for (const std::size_t bead : {std::size_t{0}, t.beads() - 1}) out += bead_label(t, bead, height);
  return out + plots + "\nunset label\n";
}

}  // namespace

void plot_trajectories(std::span<const Panel> panels, std::size_t columns, std::span<const std::string> differ,
                       const std::string& title, const std::string& path, bool by_phase) {
  require_room_for(panels.size());
  const Form form = form_of(path);
  columns = std::clamp<std::size_t>(columns, 1, std::min<std::size_t>(panels.size(), 6));
  const std::size_t lines = (panels.size() + columns - 1) / columns;
  const std::string terminal = panels_terminal(form, 330.0 * double(columns), 60.0 + 280.0 * double(lines));
  std::string script = fmt::format("set encoding utf8\nset terminal {}\n", terminal);
  script += fmt::format("set multiplot layout {},{} rowsfirst title {} noenhanced\n", lines, columns, quoted(title));
  script +=
      "unset key\nset rmargin 4\nset border 3 linecolor '#404040'\nset tics nomirror out\n"
      "set xzeroaxis linetype 1 linecolor '#A0A0A0' linewidth 0.8\n";
  for (std::size_t k = 0; k < panels.size(); ++k) script += panel_script(panels[k], k, differ, by_phase);
  run_gnuplot(script + "unset multiplot\n", path);
}

}  // namespace sigmasweep
