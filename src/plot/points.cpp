#include "plot/points.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace sigmasweep::plot {
namespace {

/// A text as a cell, in quotes if it needs them.
std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\n") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string points_as_csv(const Figure& figure, std::span<const Row> rows, const PlotSpec& spec) {
  std::string text = fmt::format("curve,{},{},error,row\n", cell(spec.x), cell(spec.y));
  for (const Curve& curve : figure.curves)
    for (const Point& p : curve.line ? curve.path : curve.points) {
      const std::string row = p.row == Point::no_row ? "" : fmt::format("{}", rows[p.row].index);
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", cell(curve.name), p.x, p.y, p.deviation, row);
    }
  return text;
}

}  // namespace sigmasweep::plot
