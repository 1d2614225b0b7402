#include "studies/precision/spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/study.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep {
namespace {

using namespace spec;

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

constexpr auto keys = std::to_array<Key<PrecisionSpec>>({
    {{"integrators", KeyForm::choices, "integrators to compare", "all", names_of<Integrator>()},
     [](const Entry& entry, PrecisionSpec& study) { study.integrators = as_integrators(entry); }},
    {{"steps_per_tc", KeyForm::numbers, "of the integrators of fixed step", "[20, 50, 100, 200, 500, 1000]"},
     [](const Entry& entry, PrecisionSpec& study) { study.steps_per_tc = as_ladder(entry, 1e9); }},
    {{"tolerances", KeyForm::numbers, "of exact", "[1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13]"},
     [](const Entry& entry, PrecisionSpec& study) { study.tolerances = as_ladder(entry, 1.0); }},
    {{"tuples", KeyForm::whole_number, "random contact phases of a scene", "400"},
     [](const Entry& entry, PrecisionSpec& study) { study.tuples = as_count(entry, 1, max_tuples); }},
    {{"checks", KeyForm::whole_number, "number of tuples with both references", "20"},
     [](const Entry& entry, PrecisionSpec& study) { study.checks = as_count(entry, 1, max_tuples); }},
    {{"repeats", KeyForm::whole_number, "number of timings; the smallest counts", "5"},
     [](const Entry& entry, PrecisionSpec& study) { study.repeats = as_count(entry, 1, max_repeats); }},
    {{"seconds", KeyForm::number, "CPU time for the tuples of one setting, or for the references, s", "0.1"},
     [](const Entry& entry, PrecisionSpec& study) { study.seconds = as_positive(entry, 1e6); }},
    {{"repeat_seconds", KeyForm::number, "a setting that has taken longer is not timed again, s", "1"},
     [](const Entry& entry, PrecisionSpec& study) { study.repeat_seconds = as_positive(entry, 1e6); }},
    {{"longest", KeyForm::number, "largest CPU time of a tuple, s; slower settings are left out", "0.5"},
     [](const Entry& entry, PrecisionSpec& study) { study.longest = as_positive(entry, 1e6); }},
    {{"seed", KeyForm::whole_number, "of the contact phases", "0"},
     [](const Entry& entry, PrecisionSpec& study) { study.seed = as_count(entry, 0, INT64_MAX); }},
});

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
  read_keys(table, keys, study);
  require_scenes(table, sweep);
  return study;
}

std::vector<spec::KeyInfo> keys_of_precision() { return infos_of(keys); }

std::optional<PrecisionSpec> precision_of(const Sweep& sweep) {
  const spec::Entry* table = sweep.section(precision_section.name);
  return table ? std::optional(read_precision(*table, sweep)) : std::nullopt;
}

}  // namespace sigmasweep
