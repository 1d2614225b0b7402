#include "studies/precision/spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/study.hpp"
#include "sweep/spec/entry.hpp"

namespace sigmasweep {
namespace {

using namespace spec;

constexpr std::array<std::string_view, 10> keys{"integrators", "steps_per_tc", "tolerances",     "tuples",  "checks",
                                                "repeats",     "seconds",      "repeat_seconds", "longest", "seed"};
constexpr std::uint64_t max_scenes = 10'000, max_tuples = 1'000'000, max_repeats = 1000;

double as_positive(const Entry& entry, double most) {
  const double value = as_number(entry);
  if (!(value > 0.0 && value <= most)) refuse_value(entry, fmt::format("must be a number > 0 and at most {}", most));
  return value;
}

std::vector<double> as_ladder(const Entry& entry, double most) {
  std::vector<double> ladder;
  for (const Entry& element : elements(entry)) ladder.push_back(as_positive(element, most));
  if (ladder.empty()) refuse(entry, "needs at least one value");
  return ladder;
}

std::vector<Integrator> as_integrators(const Entry& entry) {
  std::vector<Integrator> integrators;
  for (const Entry& element : elements(entry)) {
    integrators.push_back(static_cast<Integrator>(as_one_of(element, names_of<Integrator>())));
    if (std::ranges::count(integrators, integrators.back()) > 1) refuse_value(element, "is there already");
  }
  if (integrators.empty()) refuse(entry, "needs at least one integrator");
  return integrators;
}

/// Refuses a sweep whose axes are settings of the study, or whose scenes have no integrators.
void require_scenes(const Entry& table, const Sweep& sweep) {
  if (sweep.size() > max_scenes)
    refuse(table, fmt::format("{} rows are as many scenes, at most {} are allowed", sweep.size(), max_scenes));
  for (const std::string& axis : sweep.axes())
    if (axis == "integrator" || axis == "steps_per_tc" || axis == "tolerance")
      refuse(table, fmt::format("'{}' is an axis of [sweep], but [precision] has its own", axis));
  for (std::uint64_t scene = 0; scene < sweep.size(); ++scene)
    if (sweep.at(scene).method != Method::md)
      refuse(table, "only soft spheres, method = 'md', have integrators to compare");
}

}  // namespace

PrecisionSpec read_precision(const spec::Entry& table, const Sweep& sweep) {
  PrecisionSpec study;
  for (const Entry& entry : entries(as_table(table), *table.file, table.path)) {
    if (entry.name == "integrators")
      study.integrators = as_integrators(entry);
    else if (entry.name == "steps_per_tc")
      study.steps_per_tc = as_ladder(entry, 1e9);
    else if (entry.name == "tolerances")
      study.tolerances = as_ladder(entry, 1.0);
    else if (entry.name == "tuples")
      study.tuples = as_count(entry, 1, max_tuples);
    else if (entry.name == "checks")
      study.checks = as_count(entry, 1, max_tuples);
    else if (entry.name == "repeats")
      study.repeats = as_count(entry, 1, max_repeats);
    else if (entry.name == "seconds")
      study.seconds = as_positive(entry, 1e6);
    else if (entry.name == "repeat_seconds")
      study.repeat_seconds = as_positive(entry, 1e6);
    else if (entry.name == "longest")
      study.longest = as_positive(entry, 1e6);
    else if (entry.name == "seed")
      study.seed = as_count(entry, 0, INT64_MAX);
    else
      refuse_unknown(entry, keys);
  }
  require_scenes(table, sweep);
  return study;
}

std::optional<PrecisionSpec> precision_of(const Sweep& sweep) {
  const spec::Entry* table = sweep.section(precision_section.name);
  return table ? std::optional(read_precision(*table, sweep)) : std::nullopt;
}

}  // namespace sigmasweep
