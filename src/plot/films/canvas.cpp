#include "plot/films/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plot/gnuplot/gnuplot.hpp"

namespace sigmasweep::plot {
namespace {

std::string rectangle(double x0, double z0, double x1, double z1) {
  return fmt::format(
      "set object rectangle from {:.6g},{:.6g} to {:.6g},{:.6g} fillcolor rgb '#707070' fillstyle solid "
      "noborder behind\n",
      x0, z0, x1, z1);
}

std::string walls(const Trajectory& t, const View& view, double bottom) {
  std::string out = "unset object\nunset arrow\n" + rectangle(view.x0, bottom - view.wall, view.x1, bottom);
  if (!t.periodic)
    return out + rectangle(view.x0, bottom - view.wall, 0.0, view.z1) +
           rectangle(t.box_width, bottom - view.wall, view.x1, view.z1);
  for (const double x : {0.0, t.box_width})
    out += fmt::format(
        "set arrow from {0:.6g},{1:.6g} to {0:.6g},{2:.6g} nohead front dashtype 3 linecolor rgb "
        "'#606060'\n",
        x, bottom, view.z1);
  return out;
}

}  // namespace

std::string Canvas::margins(double x, double y, double w, double h) const {
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n"
      "set bmargin at screen {:.6f}\n",
      x / width, (x + w) / width, 1.0 - y / height, 1.0 - (y + h) / height);
}

std::string Canvas::label(const std::string& text, double x, double y, std::string_view options) const {
  return fmt::format("set label {} at screen {:.6f},{:.6f} {}\n", quoted(text), x / width, 1.0 - y / height, options);
}

double View::scale() const { return std::min(frame_width / (x1 - x0), max_height / (z1 - z0)); }

View view_of(const Trajectory& t, double lowest, double highest, double beyond, double frame_width) {
  const double thick = 0.025 * t.box_width, sides = t.periodic ? beyond : thick;
  return {-sides, t.box_width + sides, lowest - thick, highest + thick, thick, frame_width};
}

std::string frame_with_walls(const Trajectory& t, const View& view, double bottom, const Canvas& canvas, double x,
                             double y) {
  return canvas.margins(x + 0.5 * (view.frame_width - view.width()), y, view.width(), view.height()) +
         fmt::format("set xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\n", view.x0, view.x1, view.z0, view.z1) +
         walls(t, view, bottom);
}

}  // namespace sigmasweep::plot
