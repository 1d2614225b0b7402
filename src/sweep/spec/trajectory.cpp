#include "sweep/spec/trajectory.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sweep/expression/where.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::uint64_t max_samples = 1'000'000, max_values = std::uint64_t{1} << 26;
constexpr std::uint64_t max_searched = std::uint64_t{1} << 24;  // rows that `where` selects from; a few seconds

double as_duration(const Entry& entry) {
  const double duration = as_number(entry);
  if (!(duration > 0.0 && std::isfinite(duration))) refuse_value(entry, "must be a finite number > 0, in s");
  return duration;
}

ParameterWhere as_condition(const Entry& entry) {
  try {
    return ParameterWhere(as_string(entry), fields_of_parameters());
  } catch (const UsageError& error) {
    refuse_value(entry, error.what());
  }
}

/// The rows that satisfy `where`, or all rows if it is null.
std::vector<std::uint64_t> chosen_rows(const Entry& table, const Entry* where, const Sweep& sweep) {
  const auto too_many = [&](const Entry& entry, std::uint64_t most, std::string_view rows) {
    refuse(entry, fmt::format("{}: at most {} are allowed; choose rows with 'where'", rows, most));
  };
  if (where == nullptr && sweep.size() > TrajectorySpec::max_files)
    too_many(table, TrajectorySpec::max_files, fmt::format("{} rows are {} files", sweep.size(), sweep.size()));
  if (sweep.size() > max_searched) too_many(table, max_searched, fmt::format("{} rows to choose from", sweep.size()));
  std::optional<ParameterWhere> condition;
  if (where != nullptr) condition = as_condition(*where);
  std::vector<std::uint64_t> rows;
  for (std::uint64_t k = 0; k < sweep.size(); ++k) {
    if (condition && !(*condition)(sweep.at(k))) continue;
    if (rows.size() == TrajectorySpec::max_files) too_many(*where, TrajectorySpec::max_files, "too many rows");
    rows.push_back(k);
  }
  if (rows.empty()) refuse_value(*where, "no row satisfies it");
  return rows;
}

void require_room(const Entry& table, const TrajectorySpec& spec, const Sweep& sweep) {
  for (const std::uint64_t row : spec.rows)
    if (const Parameters p = sweep.at(row);
        static_cast<std::uint64_t>(p.N) * (is_lattice(p) ? 2 : 1) > max_values / spec.samples)
      refuse(table, fmt::format("{} samples of the {} beads of row {} are too much for a file: at most {} coordinates "
                                "are allowed",
                                spec.samples, p.N, row, max_values));
}

struct Contents {
  TrajectorySpec spec;  ///< without its rows
  std::optional<Entry> where;
};

constexpr auto keys = std::to_array<Key<Contents>>({
    {{"samples", KeyForm::whole_number, "number of samples, evenly spaced in time, both ends included", "1001"},
     [](const Entry& entry, Contents& table) { table.spec.samples = as_count(entry, 2, max_samples); }},
    {{"duration", KeyForm::number, "time from the start, s",
      "1.5 times the time to the last contact with the wall; on a plate 10 periods"},
     [](const Entry& entry, Contents& table) { table.spec.duration = as_duration(entry); }},
    {{"where", KeyForm::condition, "condition on the parameters of the rows that are recorded", "all rows"},
     [](const Entry& entry, Contents& table) { as_condition(*(table.where = entry)); }},
});

Contents read_contents(const Entry& table) {
  Contents contents;
  read_keys(table, keys, contents);
  return contents;
}

}  // namespace

void require_trajectory_keys(const Entry& table) { read_contents(table); }

TrajectorySpec read_trajectory(const Entry& table, const Sweep& sweep) {
  auto [spec, where] = read_contents(table);
  spec.rows = chosen_rows(table, where ? &*where : nullptr, sweep);
  require_room(table, spec, sweep);
  return spec;
}

std::vector<KeyInfo> keys_of_trajectory() { return infos_of(keys); }

}  // namespace sigmasweep::spec
