#pragma once

#include <span>
#include <vector>

#include "plot/figure/figure.hpp"

namespace sigmasweep::plot {

/// The points that are needed to draw a line (Ramer 1972, Douglas & Peucker 1973). Points that are within `tolerance`,
/// a fraction of width and height, of the line through the others are left out, and so are points that are not finite.
std::vector<Point> thinned(std::span<const Point> points, double width, double height, double tolerance);

}  // namespace sigmasweep::plot
