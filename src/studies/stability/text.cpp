#include "studies/stability/text.hpp"

#include <fmt/format.h>

#include <map>

#include "studies/stability/map.hpp"

namespace sigmasweep {
namespace {

/// Counts of the rows at one y.
struct Line {
  double most = 0.0;    ///< largest tc/dt at which a row was unstable
  double fewest = 0.0;  ///< smallest tc/dt from which on all rows were stable
  double predicted = 0.0;
};

std::map<double, Line> lines_of(const StabilityMap& map) {
  std::map<double, Line> lines;
  for (const StabilityCell& cell : map.cells) {
    Line& line = lines[cell.y];
    if (cell.observed == Observed::unstable) line.most = std::max(line.most, cell.steps);
  }
  for (const StabilityCell& cell : map.cells) {
    Line& line = lines[cell.y];
    if (cell.steps > line.most && (line.fewest == 0.0 || cell.steps < line.fewest)) line.fewest = cell.steps;
  }
  for (const StabilityLimit& limit : map.limits)
    if (const auto line = lines.find(limit.y); line != lines.end()) line->second.predicted = limit.steps;
  return lines;
}

std::string step(double steps) { return steps > 0.0 ? fmt::format("tc/{:.4g}", steps) : "-"; }

struct Count {
  std::uint64_t agree = 0, only_theory = 0, only_rows = 0, nothing = 0;
  void take(const StabilityCell& cell) {
    const bool unstable = cell.observed == Observed::unstable;
    if (cell.observed == Observed::nothing)
      ++nothing;
    else if (unstable != cell.predicted_stable)
      ++agree;
    else
      ++(unstable ? only_rows : only_theory);
  }
};

}  // namespace

std::string stability_text(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes) {
  const std::string y(stability_axis(plot).name);
  std::string out;
  Count count;
  for (const StabilityMap& map : stability_maps(rows, plot, axes)) {
    out += fmt::format("{}{}\n  {:>9}  {:>12}  {:>13}  {:>15}\n", out.empty() ? "" : "\n", map.plain_label, y,
                       "stable from", "unstable at", "predicted limit");
    for (const auto& [value, line] : lines_of(map))
      out += fmt::format("  {:>9.4g}  {:>12}  {:>13}  {:>15}\n", value, step(line.fewest), step(line.most),
                         step(line.predicted));
    for (const StabilityCell& cell : map.cells) count.take(cell);
  }
  out += fmt::format(
      "\n{} rows as predicted; {} predicted to be unstable, but without visible growth (the beads separate before);\n"
      "{} unstable, but predicted to be stable",
      count.agree, count.only_theory, count.only_rows);
  return out + (count.nothing > 0 ? fmt::format("; {} without a result for other reasons\n", count.nothing) : "\n");
}

}  // namespace sigmasweep
