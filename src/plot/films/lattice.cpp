#include "plot/films/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "assembly/ground.hpp"
#include "plot/films/canvas.hpp"
#include "plot/gnuplot/gnuplot.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

using namespace plot;

constexpr std::size_t frames_per_strip = 6;
constexpr double frame_width = 150.0, frame_gap = 14.0;  // pixels of an SVG
constexpr double above = 28.0, below = 42.0, head = 44.0, left = 16.0, right = 96.0;

/// Number of samples before the solver gave up, or of all samples.
std::size_t finite_samples(const Trajectory& t) {
  const auto missing = std::ranges::find_if(t.z, [](double z) { return !std::isfinite(z); });
  return static_cast<std::size_t>(missing - t.z.begin()) / std::max<std::size_t>(t.beads(), 1);
}

double centre_of_mass(const Trajectory& t, std::size_t sample) {
  double moment = 0.0;
  for (std::size_t i = 0; i < t.beads(); ++i) moment += t.mass[i] * t.z[sample * t.beads() + i];
  return moment;
}

bool touches_bottom(const Trajectory& t, std::size_t sample) {
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < t.beads(); ++i)
    if (t.z[sample * t.beads() + i] < 0.5 * t.diameter[i] * (1.0 - rounding)) return true;
  return false;
}

std::vector<FilmFrame> frames_of_collision(const Trajectory& t, std::size_t samples) {
  std::size_t touch = 0, lowest = 0;
  while (touch + 1 < samples && !touches_bottom(t, touch)) ++touch;
  for (std::size_t s = 1; s < samples; ++s)
    if (centre_of_mass(t, s) < centre_of_mass(t, lowest)) lowest = s;
  const std::size_t last = samples - 1;
  return {{0, "start"},
          {touch, "first contact"},
          {(touch + std::max(touch, lowest)) / 2, ""},
          {lowest, "centre of mass lowest"},
          {lowest + (last - lowest) / 3, ""},
          {last, "end"}};
}

std::vector<FilmFrame> frames_of_period(const Panel& panel, std::size_t samples) {
  const std::vector<double>& time = panel.trajectory.time;
  const double f = panel.row.parameters.frequency;
  const double begin = std::max(std::floor(time[samples - 1] * f * (1.0 + 1e-12)) - 1.0, 0.0);
  std::vector<FilmFrame> frames;
  for (std::size_t k = 0; k < frames_per_strip; ++k) {
    const double phase = static_cast<double>(k) / frames_per_strip, wanted = (begin + phase) / f;
    const auto nearest =
        std::ranges::min_element(std::span(time).first(samples), {}, [&](double t) { return std::abs(t - wanted); });
    frames.push_back(
        {static_cast<std::size_t>(nearest - std::span(time).begin()), fmt::format("period {:.0f}", begin + 1.0)});
  }
  return frames;
}

View view_of_strip(const Panel& panel, std::span<const FilmFrame> frames) {
  const Trajectory& t = panel.trajectory;
  if (frames.empty()) return {0.0, 1.0, 0.0, 0.1, 0.0, frame_width};
  const double lowest = has_plate(panel) ? -panel.row.parameters.A0 : 0.0;
  double start = 0.0, highest = 0.0;
  for (const FilmFrame& frame : frames)
    for (std::size_t i = 0; i < t.beads(); ++i) {
      highest = std::max(highest, t.z[frame.sample * t.beads() + i] + 0.5 * t.diameter[i]);
      start = std::max(start, t.z[i] + 0.5 * t.diameter[i]);
    }
  highest = std::min(highest, std::max(3.0 * start, 3.0 * t.box_width));  // single beads may fly far
  return view_of(t, lowest, highest, 0.5 * std::ranges::max(t.diameter), frame_width);
}

/// The scale of colours for velocities, the same for all strips.
struct SpeedScale {
  bool in_v0;      ///< velocities in units of v0 instead of m/s
  double largest;  ///< colours go from -largest to largest
  double operator()(double speed, const Parameters& p) const { return in_v0 ? speed / p.v0 : speed; }
};

SpeedScale speed_scale(std::span<const Panel> panels) {
  if (std::ranges::none_of(panels, has_plate)) return {true, 1.0};
  double largest = 0.0;
  for (const Panel& panel : panels)
    for (const double v : panel.trajectory.velocity)
      if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  if (largest <= 0.0) return {false, 1.0};
  const double digit = std::pow(10.0, std::floor(std::log10(largest)));
  return {false, std::ceil(largest / digit) * digit};
}

/// Adds a disc as a polygon, a line "x z speed" for each corner. Gnuplot's own circles have 120 corners, which makes an
/// SVG of many MB.
void put_disc(std::string& out, double x, double z, double r, double speed) {
  constexpr int corners = 24;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    fmt::format_to(std::back_inserter(out), "{:.6g} {:.6g} {:.4g}\n", x + r * std::cos(angle), z + r * std::sin(angle),
                   speed);
  }
  out += "\n";
}

/// The polygons of all beads. In a periodic container a bead across one end is drawn at both ends.
std::string discs(const Panel& panel, std::size_t sample, const SpeedScale& speed) {
  const Trajectory& t = panel.trajectory;
  std::string out;
  for (std::size_t i = 0; i < t.beads(); ++i) {
    const std::size_t k = sample * t.beads() + i;
    const double r = 0.5 * t.diameter[i], w = t.box_width;
    const auto put = [&](double x) { put_disc(out, x, t.z[k], r, speed(t.velocity[k], panel.row.parameters)); };
    if (!t.periodic) {
      put(t.x[k]);
      continue;
    }
    const double x = t.x[k] - w * std::floor(t.x[k] / w);
    put(x);
    if (x < r) put(x + w);
    if (x > w - r) put(x - w);
  }
  return out;
}

std::string time_label(const Panel& panel, double t) {
  const Parameters& p = panel.row.parameters;
  if (!has_plate(panel)) return fmt::format("{{/:Italic t}} = {:.3g} {}", t / p.tc, symbol_of(*find_field("tc")));
  return fmt::format("{{/:Italic ωt}}/2π = {:.2f}", t * p.frequency - std::floor(t * p.frequency));
}

std::string frame_script(const Panel& panel, const FilmFrame& frame, const View& view, const SpeedScale& speed,
                         const Canvas& canvas, double x, double y, const std::string& name) {
  const Parameters& p = panel.row.parameters;
  const double time = panel.trajectory.time[frame.sample], plate = has_plate(panel) ? plate_height(p, time) : 0.0;
  std::string out = fmt::format("${} << end_of_discs\n{}end_of_discs\n", name, discs(panel, frame.sample, speed));
  out += frame_with_walls(panel.trajectory, view, plate, canvas, x, y);
  const double middle = x + 0.5 * frame_width, under = y + view.height();
  out += canvas.label(time_label(panel, time), middle, under + 12.0, "center") +
         canvas.label(frame.caption, middle, under + 27.0, "center font ',9' textcolor rgb '#606060'");
  return out + fmt::format(
                   "plot ${0} using 1:2:3 with polygons linecolor palette fillstyle solid noborder notitle, "
                   "${0} using 1:2 with lines linecolor rgb '#303030' linewidth 0.3 notitle\n"
                   "unset label\nunset colorbox\n",
                   name);
}

std::string colour_box(const SpeedScale& speed, const Canvas& canvas, double height) {
  const double bar = std::min(height, 220.0);
  return fmt::format(
      "set palette defined (-1 '#2166AC', -0.5 '#92C5DE', 0 '#F7F7F7', 0.5 '#F4A582', 1 '#B2182B')\n"
      "set cbrange [{0:.6g}:{1:.6g}]\nset cbtics {1:.6g} out scale 0.5\nset cblabel '{2}'\n"
      "set colorbox user origin screen {3:.6f},{4:.6f} size screen {5:.6f},{6:.6f}\n",
      -speed.largest, speed.largest,
      speed.in_v0 ? fmt::format("{{/:Italic v_z}}/{}", symbol_of(*find_field("v0"))) : "{/:Italic v_z} (m/s)",
      (canvas.width - right + 16.0) / canvas.width, 1.0 - (head + above + bar) / canvas.height, 14.0 / canvas.width,
      bar / canvas.height);
}

struct Strip {
  std::vector<FilmFrame> frames;
  View view;
};

std::string strip_script(const Panel& panel, std::size_t number, const Strip& strip, const SpeedScale& speed,
                         const Canvas& canvas, double y, std::span<const std::string> differ) {
  std::string out = canvas.label(panel_title(number, panel.row, differ), left, y + 14.0, "left");
  if (strip.frames.empty()) out += "plot [0:1][0:1] NaN notitle\nunset label\n";
  for (std::size_t k = 0; k < strip.frames.size(); ++k)
    out += frame_script(panel, strip.frames[k], strip.view, speed, canvas,
                        left + static_cast<double>(k) * (frame_width + frame_gap), y + above,
                        fmt::format("strip{}_{}", number, k));
  return out;
}

}  // namespace

std::vector<FilmFrame> film_frames(const Panel& panel) {
  const std::size_t samples = finite_samples(panel.trajectory);
  if (samples == 0) return {};
  std::vector<FilmFrame> frames =
      has_plate(panel) ? frames_of_period(panel, samples) : frames_of_collision(panel.trajectory, samples);
  std::ranges::stable_sort(frames, {}, &FilmFrame::sample);
  const auto same = std::ranges::unique(frames, {}, &FilmFrame::sample);
  frames.erase(same.begin(), same.end());
  return frames;
}

void plot_lattices(std::span<const Panel> panels, std::span<const std::string> differ, const std::string& title,
                   const std::string& path) {
  require_room_for(panels.size());
  const Form form = form_of(path);
  std::vector<Strip> strips;
  Canvas canvas{left + frames_per_strip * (frame_width + frame_gap) + right, head};
  for (const Panel& panel : panels) {
    std::vector<FilmFrame> frames = film_frames(panel);
    const View view = view_of_strip(panel, frames);
    canvas.height += above + view.height() + below;
    strips.push_back({std::move(frames), view});
  }
  const SpeedScale speed = speed_scale(panels);
  std::string script = fmt::format("set encoding utf8\nset terminal {}\nset multiplot title {} noenhanced\n",
                                   panels_terminal(form, canvas.width, canvas.height), quoted(title));
  script +=
      "unset key\nunset border\nunset xtics\nunset ytics\n" + colour_box(speed, canvas, strips.front().view.height());
  double y = head;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    script += strip_script(panels[k], k, strips[k], speed, canvas, y, differ);
    y += above + strips[k].view.height() + below;
  }
  run_gnuplot(script + "unset multiplot\n", path);
}

}  // namespace sigmasweep
