#pragma once

#include <string>
#include <string_view>

#include "sigmasweep/trajectory/trajectory.hpp"

/// Where things are on a picture of many frames, in pixels of an SVG.
namespace sigmasweep::plot {

/// From its upper left corner; gnuplot's screen has its origin at the lower left.
struct Canvas {
  double width, height;
  std::string margins(double x, double y, double w, double h) const;
  /// `how`: the rest of gnuplot's command.
  std::string label(const std::string& text, double x, double y, std::string_view how) const;
};

/// What a frame shows of a container, m, to scale: as wide as the frame, but not higher than allowed.
struct View {
  double x0, x1, z0, z1;
  double wall;                          ///< how thick walls are drawn
  double frame_width, tallest = 420.0;  ///< pixels
  double scale() const;                 ///< pixels per m
  double height() const { return scale() * (z1 - z0); }
  double width() const { return scale() * (x1 - x0); }
};

/// Of a container with room to the sides for walls, or for what sticks out by `beyond` where it is periodic.
View view_of(const Trajectory& trajectory, double lowest, double highest, double beyond, double frame_width);

/// The commands for ranges and margins of a frame at (x, y), and for the walls, the bottom being at this height.
std::string frame_with_walls(const Trajectory& trajectory, const View& view, double bottom, const Canvas& canvas,
                             double x, double y);

}  // namespace sigmasweep::plot
