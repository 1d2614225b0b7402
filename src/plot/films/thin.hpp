#pragma once

#include <span>
#include <vector>

#include "plot/figure/figure.hpp"

namespace sigmasweep::plot {

/// The points of a line that are needed to draw it: leaves out what is nowhere further than `tolerance`, a fraction of
/// width and height, from the line through the others (Ramer 1972, Douglas & Peucker 1973). Points that are not finite
/// are left out too.
std::vector<Point> thinned(std::span<const Point> points, double width, double height, double tolerance);

}  // namespace sigmasweep::plot
