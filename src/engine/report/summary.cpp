#include "engine/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/functional/hash.hpp>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "base/duration.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "sigmasweep/model/names.hpp"

namespace sigmasweep {
namespace {

constexpr double same_sigma = 1e-12;  // a few hundred roundings: s0/(v0 tc) of decimal inputs differs by a few

/// Of a lattice, where the beads' size in the unit of length v0 tc counts, too. Rounded, as sigma may be.
auto lattice_kind(const Parameters& p) {
  if (!is_lattice(p)) return std::tuple(std::int64_t{0}, std::int64_t{0}, SideWalls{}, 0.0f, 0.0f);
  return std::tuple(p.rows, p.columns, p.side_walls, static_cast<float>(p.d / (p.v0 * p.tc)),
                    static_cast<float>(p.D_t * p.tc));
}

/// Numbers that are equal, besides sigma, if two rows are the same point.
auto kind(const Parameters& p) {
  const double accuracy = p.integrator == Integrator::exact || p.steps_per_tc == 0.0 ? p.tolerance : p.steps_per_tc;
  const auto [beta, gamma] = exponents(p);
  return std::tuple(p.N, p.epsilon, p.method, p.wall, p.integrator, accuracy, beta, gamma, p.ed_rule, p.width / p.d,
                    p.random_separation, p.seed, p.geometry, lattice_kind(p));
}

/// A row with a result, by the hash of its kind.
struct Point {
  std::uint64_t kind;
  double sigma;
  std::uint64_t place;
  bool operator<(const Point& other) const { return std::tie(kind, sigma) < std::tie(other.kind, other.sigma); }
};

bool same_point(const Point& a, const Point& b) {
  return a.kind == b.kind && b.sigma - a.sigma <= same_sigma * std::abs(b.sigma);
}

std::vector<Point> sorted_points(const RowSource& rows) {
  std::vector<Point> points;
  points.reserve(rows.size());
  for (std::uint64_t k = 0; k < rows.size(); ++k) {
    const Row row = rows[k];
    if (is_success(row.result.status) && std::isfinite(row.result.eps_eff))
      points.push_back({boost::hash_value(kind(row.parameters)), row.parameters.sigma, k});
  }
  std::ranges::sort(points, std::less<>{});
  return points;
}

auto scales(const Parameters& p) { return std::tuple(p.v0, p.tc, p.s0); }

/// Smallest value that at least the fraction `q` of the ascending `values` does not exceed.
double quantile(const std::vector<double>& values, double q) {
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

std::string quantile_lines(const std::vector<Quantiles>& quantiles) {
  std::string lines = fmt::format("  {:<15}{:>11}{:>11}{:>11}{:>11}\n", "", "median", "90 %", "99 %", "max");
  for (const auto& [name, values] : quantiles) {
    lines += fmt::format("  {:<15}", name);
    for (const double value : values)
      lines += fmt::format("{:>11}", name == "run_time" ? readable_duration(value) : fmt::format("{:.1e}", value));
    lines += "\n";
  }
  return lines;
}

std::string status_lines(std::uint64_t rows, const Overview& seen) {
  std::string lines = fmt::format("{} row{}\n", rows, rows == 1 ? "" : "s");
  for (const auto& [name, count] : seen.by_status) lines += fmt::format("  {:<17}{:>9}\n", name, count);
  return lines;
}

/// Where the time went that is not the best possible.
std::string losses(const Work& work, int ranks, double wall_seconds) {
  if (!(work.computing_seconds > 0.0)) return {};
  return fmt::format("  ranks had a row {:.0f} % of the time, and then {:.0f} % of a processor each\n",
                     100.0 * std::min(1.0, work.computing_seconds / (ranks * wall_seconds)),
                     100.0 * std::min(1.0, work.cpu_seconds / work.computing_seconds));
}

std::string makespan(const Work& work, int ranks, double wall_seconds) {
  if (work.rows == 0 || wall_seconds <= 0.0) return {};
  const double bound = least_seconds(work, ranks);
  return fmt::format("  computed {} rows in {} on {} rank{}: {:.1f} % of the best possible, {} (sum {}, longest {})\n",
                     work.rows, readable_duration(wall_seconds), ranks, ranks == 1 ? "" : "s",
                     100.0 * bound / wall_seconds, readable_duration(bound), readable_duration(work.cpu_seconds),
                     readable_duration(work.longest_seconds)) +
         losses(work, ranks, wall_seconds);
}

std::string universal(const Universality& found) {
  if (found.groups == 0) return {};
  return fmt::format("  equal sigma, other v0, tc, s0: eps_eff within {:.1e} (worst at sigma = {:.6g}; {} group{})\n",
                     found.spread, found.sigma, found.groups, found.groups == 1 ? "" : "s");
}

}  // namespace

Universality universality(const RowSource& rows) {
  constexpr std::uint64_t most_rows = std::uint64_t{1} << 22;  // rows are looked up in any order
  if (rows.size() > most_rows) return {};
  const std::vector<Point> sorted = sorted_points(rows);
  Universality result;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    // Measured from the group's first row: groups cannot creep along a fine axis.
    const auto end = std::find_if(begin, sorted.end(), [&](const Point& point) { return !same_point(*begin, point); });
    const Row first = rows[begin->place];
    double least = first.result.eps_eff, most = least;
    bool other_scales = false;
    for (auto point = begin + 1; point < end; ++point) {
      const Row row = rows[point->place];
      other_scales = other_scales || scales(row.parameters) != scales(first.parameters);
      least = std::min(least, row.result.eps_eff);
      most = std::max(most, row.result.eps_eff);
    }
    if (other_scales) {
      ++result.groups;
      if (most - least >= result.spread) result.spread = most - least, result.sigma = begin->sigma;
    }
    begin = end;
  }
  return result;
}

Overview overview(const RowSource& rows) {
  Overview seen;
  for (const std::string_view name : names_of<Status>()) seen.by_status.emplace_back(name, 0);
  std::array<std::vector<double>, 4> values;
  for (std::uint64_t k = 0; k < rows.size(); ++k) {
    const Row row = rows[k];
    ++seen.by_status.at(static_cast<std::size_t>(row.result.status)).second;
    seen.failed += !is_success(row.result.status);
    const std::array of_row{row.result.eps_eff_error, row.result.vibration.h_cm_error,
                            std::abs(row.result.vibration.imbalance), row.timing.run_time};
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isnan(of_row[i])) values[i].push_back(of_row[i]);
  }
  std::erase_if(seen.by_status, [](const auto& count) { return count.second == 0; });
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].empty()) continue;
    std::sort(values[i].begin(), values[i].end());
    static constexpr std::array names{"eps_eff_error", "h_cm_error", "|imbalance|", "run_time"};
    Quantiles& found = seen.quantiles.emplace_back(Quantiles{names[i]});
    std::ranges::transform(std::array{0.5, 0.9, 0.99, 1.0}, found.values.begin(),
                           [&](double q) { return quantile(values[i], q); });
  }
  return seen;
}

double least_seconds(const Work& work, int ranks) { return std::max(work.cpu_seconds / ranks, work.longest_seconds); }

void Work::add(double run_time) {
  ++rows;
  cpu_seconds += run_time;
  longest_seconds = std::max(longest_seconds, run_time);
}

std::string summary(const RowSource& rows, const Overview& seen, const Work& work, int ranks, double wall_seconds) {
  return status_lines(rows.size(), seen) + quantile_lines(seen.quantiles) + makespan(work, ranks, wall_seconds) +
         universal(universality(rows));
}

std::string summary(const RowSource& rows, const Work& work, int ranks, double wall_seconds) {
  return summary(rows, overview(rows), work, ranks, wall_seconds);
}

std::string summary(const RowSource& rows, int ranks, double wall_seconds) {
  Work work;
  for (std::uint64_t k = 0; k < rows.size(); ++k) work.add(rows[k].timing.run_time);
  return summary(rows, work, ranks, wall_seconds);
}

}  // namespace sigmasweep
