#include "plot/films/velocity_field.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "assembly/ground.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

constexpr double rounding = 1e-9;  // periods; a sample at the beginning of a period belongs to it

/// The time at which averages begin, in periods.
double first_time(const Panel& panel) {
  const double periods = panel.trajectory.time.back() * panel.row.parameters.frequency;
  return std::min(std::floor(periods / 3.0 + rounding), static_cast<double>(panel.row.parameters.transient));
}

std::vector<std::size_t> samples_of(const Panel& panel, std::size_t phase, std::size_t phases) {
  std::vector<std::size_t> chosen;
  const double f = panel.row.parameters.frequency, first = first_time(panel);
  for (std::size_t s = 0; s < panel.trajectory.samples(); ++s) {
    const double turns = panel.trajectory.time[s] * f + rounding;
    const auto part = static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(phases));
    if (part == phase && turns >= first) chosen.push_back(s);
  }
  return chosen;
}

/// Throws UsageError for a container of more cells than any lattice of the program has.
void require_drawable(const VelocityField& field) {
  constexpr std::size_t most_cells = 4'000'000;
  if (field.columns > most_cells / field.rows)
    throw UsageError(fmt::format("plot: a velocity field of {} x {} cells is too large: at most {} are drawn",
                                 field.columns, field.rows, most_cells));
}

/// A field without beads. Its cells reach up to the highest bead, but at most to four times the rows of the lattice.
VelocityField empty_field(Films films) {
  const Panel& first = *films.front();
  const Trajectory& t = first.trajectory;
  const double d = std::accumulate(t.diameter.begin(), t.diameter.end(), 0.0) / static_cast<double>(t.beads());
  VelocityField field;
  constexpr double most_columns = 1e9;  // fits into an integer
  field.columns = static_cast<std::size_t>(std::clamp(std::round(t.box_width / d), 1.0, most_columns));
  field.width = t.box_width / static_cast<double>(field.columns);
  field.height = d;
  field.periodic = t.periodic;
  double highest = d;
  for (const Panel* film : films)
    for (std::size_t k = 0; k < film->trajectory.z.size(); ++k)
      if (const double z = film->trajectory.z[k]; std::isfinite(z))
        highest = std::max(highest,
                           z - plate_height(film->row.parameters, film->trajectory.time[k / film->trajectory.beads()]));
  field.rows =
      static_cast<std::size_t>(std::min(std::ceil(highest / d), 4.0 * static_cast<double>(first.row.parameters.rows)));
  require_drawable(field);
  field.velocity.resize(field.columns * field.rows);
  field.filled.resize(field.columns * field.rows);
  return field;
}

/// The mean of independent values and its standard error; NaN where there are too few values.
std::pair<double, double> mean_and_error(const std::vector<double>& values) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {unknown, unknown};
  if (values.size() == 1) return {values.front(), unknown};
  const auto [mean, variance] = boost::math::statistics::mean_and_sample_variance(values);
  return {mean, std::sqrt(variance / static_cast<double>(values.size()))};
}

}  // namespace

VelocityField velocity_field(Films films, std::size_t phase, std::size_t phases) {
  constexpr double enough = 0.05;
  VelocityField field = empty_field(films);
  std::vector<double> beads(field.velocity.size()), rise(field.rows), count(field.rows);
  std::size_t all = 0;
  for (const Panel* film : films) {
    const std::vector<std::size_t> samples = samples_of(*film, phase, phases);
    all += samples.size();
    const Trajectory& t = film->trajectory;
    for (const std::size_t s : samples)
      for (std::size_t k = s * t.beads(); k < (s + 1) * t.beads(); ++k) {
        const double x = t.x[k] - t.box_width * std::floor(t.x[k] / t.box_width);
        const double z = t.z[k] - plate_height(film->row.parameters, t.time[s]);
        const double row = std::floor(z / field.height);
        if (!(row >= 0.0 && row < static_cast<double>(field.rows) && x >= 0.0))
          continue;  // NaN after the solver gave up, too
        const Vec2<double> v{t.x_velocity[k], t.velocity[k]};
        const auto column = std::min(static_cast<std::size_t>(x / field.width), field.columns - 1);
        const std::size_t cell = static_cast<std::size_t>(row) * field.columns + column;
        field.velocity[cell] += v;
        beads[cell] += 1.0;
        rise[static_cast<std::size_t>(row)] += v.z;
        count[static_cast<std::size_t>(row)] += 1.0;
      }
  }
  for (std::size_t cell = 0; cell < beads.size(); ++cell) {
    field.filled[cell] = beads[cell] > 0.0 && beads[cell] >= enough * static_cast<double>(all);
    const std::size_t row = cell / field.columns;
    field.velocity[cell] = field.filled[cell]
                               ? (1.0 / beads[cell]) * field.velocity[cell] - Vec2<double>{0.0, rise[row] / count[row]}
                               : Vec2<double>{};
  }
  return field;
}

Rolls rolls_of(const VelocityField& field) {
  double sums[2] = {0.0, 0.0}, corners[2] = {0.0, 0.0};
  const std::size_t last = field.periodic ? field.columns : field.columns - 1;
  for (std::size_t i = 0; i < last; ++i)
    for (std::size_t row = 0; row + 1 < field.rows; ++row) {
      const std::size_t j = (i + 1) % field.columns;
      if (!(field.has(i, row) && field.has(j, row) && field.has(i, row + 1) && field.has(j, row + 1))) continue;
      const Vec2<double> a = field.at(i, row), b = field.at(j, row), c = field.at(i, row + 1), e = field.at(j, row + 1);
      const double curl =
          (b.z + e.z - a.z - c.z) / (2.0 * field.width) - (c.x + e.x - a.x - b.x) / (2.0 * field.height);
      // A corner in the middle belongs to both halves, and so does the one where a periodic container is joined.
      const std::size_t twice = 2 * (i + 1);
      const bool both = twice == field.columns || i + 1 == field.columns;
      if (twice < field.columns || both) sums[0] += curl, corners[0] += 1.0;
      if (twice > field.columns || both) sums[1] += curl, corners[1] += 1.0;
    }
  return {sums[0] / corners[0], sums[1] / corners[1]};  // NaN without corners
}

MeanRolls mean_rolls(Films films, std::size_t phase, std::size_t phases) {
  std::vector<double> left, right;
  for (const Panel* film : films) {
    const Rolls rolls = rolls_of(velocity_field({&film, 1}, phase, phases));
    if (rolls.left == rolls.left) left.push_back(rolls.left);
    if (rolls.right == rolls.right) right.push_back(rolls.right);
  }
  const auto [l, l_error] = mean_and_error(left);
  const auto [r, r_error] = mean_and_error(right);
  return {{l, r}, {l_error, r_error}};
}

}  // namespace sigmasweep
