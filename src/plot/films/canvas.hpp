#pragma once

#include <string>
#include <string_view>

#include "sigmasweep/trajectory/trajectory.hpp"

/// Layout of a picture of many frames. Lengths on the picture are in pixels of an SVG.
namespace sigmasweep::plot {

/// The picture. Positions count from its upper left corner; gnuplot's screen has its origin at the lower left.
struct Canvas {
  double width, height;
  /// The command for the margins of a plot of size w × h, whose upper left corner is at (x, y).
  std::string margins(double x, double y, double w, double h) const;
  /// The command for a label; `options` is the rest of it.
  std::string label(const std::string& text, double x, double y, std::string_view options) const;
};

/// The part of a container that a frame shows, drawn to scale: as wide as the frame, but at most `max_height` high.
struct View {
  double x0, x1, z0, z1;                   ///< m
  double wall;                             ///< thickness of the walls that are drawn, m
  double frame_width, max_height = 420.0;  ///< pixels
  double scale() const;                    ///< pixels per m
  double height() const { return scale() * (z1 - z0); }
  double width() const { return scale() * (x1 - x0); }
};

/// The view of a container from `lowest` to `highest`, m, with its walls. A periodic container has a margin of `beyond`
/// at its sides instead, for beads that extend over its ends.
View view_of(const Trajectory& trajectory, double lowest, double highest, double beyond, double frame_width);

/// The commands for margins and ranges of a frame at (x, y), and for the walls, with the bottom at height `bottom`, m.
std::string frame_with_walls(const Trajectory& trajectory, const View& view, double bottom, const Canvas& canvas,
                             double x, double y);

}  // namespace sigmasweep::plot
