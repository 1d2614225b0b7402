#include "engine/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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

bool same_point(const Parameters& a, const Parameters& b) {
  return kind(a) == kind(b) && b.sigma - a.sigma <= same_sigma * std::abs(b.sigma);
}

auto scales(const Parameters& p) { return std::tuple(p.v0, p.tc, p.s0); }

/// Smallest value that at least the fraction `q` of the ascending `values` does not exceed.
double quantile(const std::vector<double>& values, double q) {
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

std::string quantile_lines(std::span<const Row> rows) {
  std::string lines = fmt::format("  {:<15}{:>11}{:>11}{:>11}{:>11}\n", "", "median", "90 %", "99 %", "max");
  for (const auto& [name, values] : quantiles(rows)) {
    lines += fmt::format("  {:<15}", name);
    for (const double value : values)
      lines += fmt::format("{:>11}", name == "run_time" ? readable_duration(value) : fmt::format("{:.1e}", value));
    lines += "\n";
  }
  return lines;
}

std::string by_status(std::span<const Row> rows) {
  const auto names = names_of<Status>();
  std::vector<std::uint64_t> counts(names.size());
  for (const Row& row : rows) ++counts[static_cast<std::size_t>(row.result.status)];
  std::string lines = fmt::format("{} row{}\n", rows.size(), rows.size() == 1 ? "" : "s");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (counts[i] > 0) lines += fmt::format("  {:<17}{:>9}\n", names[i], counts[i]);
  return lines;
}

std::string makespan(const Work& work, int ranks, double wall_seconds) {
  if (work.rows == 0 || wall_seconds <= 0.0) return {};
  const double bound = least_seconds(work, ranks);
  return fmt::format("  computed {} rows in {} on {} rank{}: {:.1f} % of the best possible, {} (sum {}, longest {})\n",
                     work.rows, readable_duration(wall_seconds), ranks, ranks == 1 ? "" : "s",
                     100.0 * bound / wall_seconds, readable_duration(bound), readable_duration(work.cpu_seconds),
                     readable_duration(work.longest_seconds));
}

std::string universal(const Universality& found) {
  if (found.groups == 0) return {};
  return fmt::format("  equal sigma, other v0, tc, s0: eps_eff within {:.1e} (worst at sigma = {:.6g}; {} group{})\n",
                     found.spread, found.sigma, found.groups, found.groups == 1 ? "" : "s");
}

}  // namespace

Universality universality(std::span<const Row> rows) {
  std::vector<const Row*> sorted;
  for (const Row& row : rows)
    if (is_success(row.result.status) && std::isfinite(row.result.eps_eff)) sorted.push_back(&row);
  std::sort(sorted.begin(), sorted.end(), [](const Row* a, const Row* b) {
    return std::tuple_cat(kind(a->parameters), std::tuple(a->parameters.sigma)) <
           std::tuple_cat(kind(b->parameters), std::tuple(b->parameters.sigma));
  });
  Universality result;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    // Measured from the group's first row: groups cannot creep along a fine axis.
    const auto end = std::find_if(begin, sorted.end(),
                                  [&](const Row* row) { return !same_point((*begin)->parameters, row->parameters); });
    const bool other_scales = std::any_of(
        begin, end, [&](const Row* row) { return scales(row->parameters) != scales((*begin)->parameters); });
    if (other_scales) {
      ++result.groups;
      const auto [least, most] = std::minmax_element(
          begin, end, [](const Row* a, const Row* b) { return a->result.eps_eff < b->result.eps_eff; });
      const double spread = (*most)->result.eps_eff - (*least)->result.eps_eff;
      if (spread >= result.spread) result.spread = spread, result.sigma = (*begin)->parameters.sigma;
    }
    begin = end;
  }
  return result;
}

std::vector<Quantiles> quantiles(std::span<const Row> rows) {
  std::array<std::vector<double>, 4> values;
  for (const Row& row : rows) {
    values[0].push_back(row.result.eps_eff_error);
    values[1].push_back(row.result.vibration.h_cm_error);
    values[2].push_back(std::abs(row.result.vibration.imbalance));
    values[3].push_back(row.timing.run_time);
  }
  std::vector<Quantiles> all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::erase_if(values[i], [](double value) { return std::isnan(value); });
    if (values[i].empty()) continue;
    std::sort(values[i].begin(), values[i].end());
    static constexpr std::array names{"eps_eff_error", "h_cm_error", "|imbalance|", "run_time"};
    Quantiles& found = all.emplace_back(Quantiles{names[i]});
    std::ranges::transform(std::array{0.5, 0.9, 0.99, 1.0}, found.values.begin(),
                           [&](double q) { return quantile(values[i], q); });
  }
  return all;
}

double least_seconds(const Work& work, int ranks) { return std::max(work.cpu_seconds / ranks, work.longest_seconds); }

void Work::add(const Row& row) {
  ++rows;
  cpu_seconds += row.timing.run_time;
  longest_seconds = std::max(longest_seconds, row.timing.run_time);
}

std::string summary(std::span<const Row> rows, const Work& work, int ranks, double wall_seconds) {
  return by_status(rows) + quantile_lines(rows) + makespan(work, ranks, wall_seconds) + universal(universality(rows));
}

std::string summary(std::span<const Row> rows, int ranks, double wall_seconds) {
  Work work;
  for (const Row& row : rows) work.add(row);
  return summary(rows, work, ranks, wall_seconds);
}

}  // namespace sigmasweep
