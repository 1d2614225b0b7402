#include "plot/films/thin.hpp"

#include <cmath>
#include <utility>

namespace sigmasweep::plot {
namespace {

/// The point between first and last that is farthest from the line through these two, with its distance.
std::pair<std::size_t, double> farthest(std::span<const Point> p, std::size_t first, std::size_t last, double width,
                                        double height) {
  const double dx = (p[last].x - p[first].x) / width, dy = (p[last].y - p[first].y) / height;
  const double length = std::hypot(dx, dy);
  std::pair<std::size_t, double> found{first, 0.0};
  for (std::size_t i = first + 1; i < last; ++i) {
    const double x = (p[i].x - p[first].x) / width, y = (p[i].y - p[first].y) / height;
    const double distance = length > 0.0 ? std::abs(x * dy - y * dx) / length : std::hypot(x, y);
    if (distance > found.second) found = {i, distance};
  }
  return found;
}

}  // namespace

std::vector<Point> thinned(std::span<const Point> points, double width, double height, double tolerance) {
  std::vector<Point> finite;
  for (const Point& point : points)
    if (std::isfinite(point.x) && std::isfinite(point.y)) finite.push_back(point);
  if (finite.size() < 3) return finite;
  std::vector<bool> kept(finite.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> to_do{{0, finite.size() - 1}};
  while (!to_do.empty()) {
    const auto [first, last] = to_do.back();
    to_do.pop_back();
    const auto [middle, distance] = farthest(finite, first, last, width, height);
    if (distance <= tolerance) continue;
    kept[middle] = true;
    to_do.push_back({first, middle});
    to_do.push_back({middle, last});
  }
  std::vector<Point> line;
  for (std::size_t i = 0; i < finite.size(); ++i)
    if (kept[i]) line.push_back(finite[i]);
  return line;
}

}  // namespace sigmasweep::plot
