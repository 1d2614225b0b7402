#include "plot/films/plot_velocity_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "plot/films/canvas.hpp"
#include "plot/films/velocity_field.hpp"
#include "plot/gnuplot/gnuplot.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

using namespace plot;

constexpr std::size_t phases = 4;
constexpr double frame_width = 230.0, frame_gap = 20.0, above = 28.0, below = 58.0, head = 44.0, side = 16.0;

/// A strip of frames: the films that are averaged, and their field in each phase.
struct Strip {
  std::vector<const Panel*> films;
  std::array<VelocityField, phases> fields;
  View view;
  double fastest = 0.0;  ///< m/s
};

void fill(Strip& strip) {
  for (std::size_t phase = 0; phase < phases; ++phase) {
    strip.fields[phase] = velocity_field(strip.films, phase, phases);
    for (const Vec2<double>& v : strip.fields[phase].velocity)
      strip.fastest = std::max(strip.fastest, std::sqrt(dot(v, v)));
  }
  const VelocityField& field = strip.fields[0];
  strip.view = view_of(strip.films.front()->trajectory, 0.0, field.height * static_cast<double>(field.rows),
                       0.5 * field.width, frame_width);
}

void require_alike(Films films) {
  const Trajectory& first = films.front()->trajectory;
  for (const Panel* film : films)
    if (film->trajectory.beads() != first.beads() || film->trajectory.box_width != first.box_width)
      throw UsageError("plot: 'mean_over' can only average containers of equal width with equally many beads");
}

std::vector<Strip> strips_of(std::span<const Panel> panels, std::span<const std::string> differ, bool means) {
  std::vector<Strip> strips;
  std::map<std::string, std::size_t> known;
  for (const Panel& panel : panels) {
    std::string values;
    for (const std::string& name : differ)
      if (const Field* field = find_field(name)) values += text(*field, panel.row) + ' ';
    const auto [place, is_new] = known.try_emplace(values, strips.size());
    if (is_new || !means) strips.emplace_back();
    strips[means ? place->second : strips.size() - 1].films.push_back(&panel);
  }
  for (Strip& strip : strips) {
    require_alike(strip.films);
    fill(strip);
  }
  return strips;
}

/// "1.2", or with the standard error of a mean "1.2 ± 0.3".
std::string curl(double mean, double error) {
  if (!(mean == mean)) return "none";
  return error == error ? fmt::format("{:.2g} ± {:.1g}", mean, error) : fmt::format("{:.3g}", mean);
}

/// The arrows as lines "x z dx dz". The middle of an arrow is the middle of its cell; the arrow of `fastest`, m/s, is
/// one and a half cells long.
std::string arrows(const VelocityField& field, double fastest) {
  const double scale = fastest > 0.0 ? 1.5 * std::min(field.width, field.height) / fastest : 0.0;
  std::string out;
  for (std::size_t row = 0; row < field.rows; ++row)
    for (std::size_t column = 0; column < field.columns; ++column) {
      if (!field.has(column, row)) continue;
      const Vec2<double> v = scale * field.at(column, row);
      const double x = (static_cast<double>(column) + 0.5) * field.width - 0.5 * v.x;
      const double z = (static_cast<double>(row) + 0.5) * field.height - 0.5 * v.z;
      fmt::format_to(std::back_inserter(out), "{:.6g} {:.6g} {:.6g} {:.6g}\n", x, z, v.x, v.z);
    }
  return out.empty() ? "NaN NaN NaN NaN\n" : out;
}

std::string frame_script(const Strip& strip, std::size_t phase, const Canvas& canvas, double x, double y,
                         const std::string& name) {
  const VelocityField& field = strip.fields[phase];
  const auto [mean, error] = mean_rolls(strip.films, phase, phases);
  std::string out = fmt::format("${} << end_of_arrows\n{}end_of_arrows\n", name, arrows(field, strip.fastest));
  out += frame_with_walls(strip.films.front()->trajectory, strip.view, 0.0, canvas, x, y);
  const double middle = x + 0.5 * frame_width, under = y + strip.view.height();
  const auto fraction = [](std::size_t k) { return static_cast<double>(k) / static_cast<double>(phases); };
  out += canvas.label(fmt::format("{{/:Italic ωt}}/2π from {} to {}", fraction(phase), fraction(phase + 1)), middle,
                      under + 12.0, "center");
  out += canvas.label(
      fmt::format("mean curl: left {}, right {} /s", curl(mean.left, error.left), curl(mean.right, error.right)),
      middle, under + 27.0, "center font ',8' textcolor rgb '#606060'");
  return out + fmt::format(
                   "plot ${} using 1:2:3:4 with vectors filled head size screen 0.005,20 linewidth 1 linecolor "
                   "rgb '#2166AC' notitle\nunset label\n",
                   name);
}

std::string strip_script(std::size_t number, const Strip& strip, const Canvas& canvas, double y,
                         std::span<const std::string> differ) {
  const std::size_t films = strip.films.size();
  const std::string mean = films > 1 ? fmt::format("; mean of {}", films) : "";
  std::string out = canvas.label(panel_title(number, strip.films.front()->row, differ), side, y + 14.0, "left");
  out += canvas.label(fmt::format("longest arrow: {:.3g} m/s{}", strip.fastest, mean), side,
                      y + above + strip.view.height() + 44.0, "left font ',9'");
  for (std::size_t phase = 0; phase < phases; ++phase)
    out += frame_script(strip, phase, canvas, side + static_cast<double>(phase) * (frame_width + frame_gap), y + above,
                        fmt::format("field{}_{}", number, phase));
  return out;
}

}  // namespace

void plot_velocity_fields(std::span<const Panel> panels, std::span<const std::string> axes,
                          std::span<const std::string> mean_over, const std::string& title, const std::string& path) {
  for (const Panel& panel : panels)
    if (!has_plate(panel) || !panel.trajectory.is_plane())
      throw UsageError("plot: only vibrated lattices have velocity fields by phase");
  const Form form = form_of(path);
  std::vector<std::string> differ;
  std::ranges::copy_if(axes, std::back_inserter(differ),
                       [&](const std::string& axis) { return std::ranges::find(mean_over, axis) == mean_over.end(); });
  const std::vector<Strip> strips = strips_of(panels, differ, !mean_over.empty());
  require_room_for(strips.size());
  Canvas canvas{2.0 * side + phases * (frame_width + frame_gap) - frame_gap, head};
  for (const Strip& strip : strips) canvas.height += above + strip.view.height() + below;
  std::string script = fmt::format("set encoding utf8\nset terminal {}\nset multiplot title {} noenhanced\n",
                                   panels_terminal(form, canvas.width, canvas.height), quoted(title));
  script += "unset key\nunset border\nunset xtics\nunset ytics\n";
  double y = head;
  for (std::size_t k = 0; k < strips.size(); ++k) {
    script += strip_script(k, strips[k], canvas, y, differ);
    y += above + strips[k].view.height() + below;
  }
  run_gnuplot(script + "unset multiplot\n", path);
}

}  // namespace sigmasweep
