#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/printable.hpp"
#include "cli/command.hpp"
#include "cli/settings_option.hpp"
#include "engine/ledger/needs.hpp"
#include "engine/report/measured_cost.hpp"
#include "engine/report/remarks.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "studies/sections.hpp"
#include "sweep/schedule.hpp"

namespace sigmasweep {
namespace {

struct PlanOptions {
  std::string spec;                   ///< path of the sweep spec
  std::vector<std::string> settings;  ///< "KEY=VALUE": keys of [sweep] that are replaced
  int ranks = 1;
  int measure = 0;  ///< number of rows to compute; 0: none
  bool json = false;
};

struct Plan {
  double core_seconds = 0.0, longest_seconds = 0.0, lower_bound_seconds = 0.0, makespan_seconds = 0.0;
  std::uint64_t longest_row = 0;
  bool sampled = false;
  SweepNeeds needs{};
  std::uint64_t useful_ranks = 1;  ///< more ranks do not end the run earlier
  std::string refused{};           ///< why this machine would not run it
  std::optional<MeasuredCost> measured{};
};

constexpr std::uint64_t max_rows = 1'000'000, samples = 200'000;

/// Corrects the predicted times by the measured ones.
void correct(Plan& plan, int ranks) {
  const double factor = plan.measured->mean;
  plan.core_seconds *= factor;
  plan.makespan_seconds *= factor;
  plan.longest_seconds = std::max(plan.longest_seconds * factor, plan.measured->longest_seconds);
  plan.lower_bound_seconds = std::max(plan.core_seconds / ranks, plan.longest_seconds);
  plan.makespan_seconds = std::max(plan.makespan_seconds, plan.lower_bound_seconds);
}

/// Neither the longest tuple nor rank 0, which has something to do for each row, can be divided.
std::uint64_t useful_ranks(const Plan& plan, std::uint64_t rows) {
  constexpr double manager_seconds = 2e-6;  // a row
  const double longest = plan.core_seconds / plan.longest_seconds;
  const double fed = plan.core_seconds / (manager_seconds * static_cast<double>(rows));
  return static_cast<std::uint64_t>(std::ceil(std::clamp(std::min(longest, fed), 1.0, static_cast<double>(rows))));
}

/// The plan from the predicted times of all rows, or for a huge sweep from a sample of evenly spread rows.
Plan plan_of(const Sweep& sweep, int ranks, int measure) {
  Plan plan;
  plan.sampled = sweep.size() > max_rows;
  const std::uint64_t count = plan.sampled ? samples : sweep.size();
  // A row in each of `count` equal parts of the sweep. The golden ratio varies its place within the part, so that the
  // sample is not in step with the axes.
  const double part = static_cast<double>(sweep.size()) / static_cast<double>(count);
  const auto row_of = [&](std::uint64_t k) {
    if (!plan.sampled) return k;
    const double turn = 0.6180339887498949 * static_cast<double>(k);
    const double place =
        part * (static_cast<double>(k) + (turn - static_cast<double>(static_cast<std::uint64_t>(turn))));
    return std::min(static_cast<std::uint64_t>(place), sweep.size() - 1);
  };
  std::vector<ScheduledTask> tasks(count);
  double sum = 0.0;
  for (std::uint64_t k = 0; k < count; ++k) {
    tasks[k] = {row_of(k), predicted_time(sweep.at(row_of(k)))};
    sum += tasks[k].predicted_seconds;
  }
  if (measure > 0) plan.measured = measure_cost(sweep, tasks, static_cast<std::size_t>(measure));
  const ScheduledTask longest = *std::ranges::max_element(tasks, {}, &ScheduledTask::predicted_seconds);
  plan.longest_seconds = longest.predicted_seconds;
  plan.longest_row = longest.row;
  plan.core_seconds = part * sum;
  plan.lower_bound_seconds = std::max(plan.core_seconds / ranks, plan.longest_seconds);
  if (!plan.sampled)
    plan.makespan_seconds = Schedule(std::move(tasks), ranks).predicted_makespan();
  else
    plan.makespan_seconds = plan.lower_bound_seconds + plan.longest_seconds * (ranks - 1) / ranks;  // Graham 1969
  if (plan.measured) correct(plan, ranks);
  plan.needs = needs_of(sweep, sweep.size(), ranks);
  plan.refused = why_too_many(sweep, sweep.size());
  plan.useful_ranks = useful_ranks(plan, sweep.size());
  return plan;
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", 1e3 * seconds);
  if (seconds < 120.0) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.3g} min", seconds / 60.0);
  return fmt::format("{:.4g} h", seconds / 3600.0);
}

std::string bytes(double count) {
  if (count < 1e9) return fmt::format("{:.3g} MB", count * 1e-6);
  return fmt::format("{:.3g} GB", count * 1e-9);
}

void print_measured(const MeasuredCost& cost) {
  const std::string error =
      std::isnan(cost.standard_error) ? "" : fmt::format(" (standard error {:.1g})", cost.standard_error);
  fmt::print("measured       {} rows need {:.3g} times the predicted time{}: times are corrected\n", cost.ratios.size(),
             cost.mean, error);
  fmt::print("               least {:.3g}, 10 % {:.3g}, median {:.3g}, 90 % {:.3g}, most {:.3g}\n", cost.quantile(0.0),
             cost.quantile(0.1), cost.quantile(0.5), cost.quantile(0.9), cost.quantile(1.0));
  if (cost.given_up > 0) fmt::print("               {} were given up after a minute\n", cost.given_up);
}

nlohmann::ordered_json measured_json(const std::optional<MeasuredCost>& cost) {
  if (!cost) return nullptr;
  return {{"rows", cost->ratios.size()},  {"mean", cost->mean},          {"standard_error", cost->standard_error},
          {"least", cost->quantile(0.0)}, {"10%", cost->quantile(0.1)},  {"median", cost->quantile(0.5)},
          {"90%", cost->quantile(0.9)},   {"most", cost->quantile(1.0)}, {"given_up", cost->given_up}};
}

void print_text(const Sweep& sweep, const Plan& plan, int ranks) {
  std::string axes;
  for (std::size_t i = 0; i < sweep.axes().size(); ++i)
    axes += fmt::format("{}{}{}", i ? ", " : "", sweep.axes()[i],
                        sweep.parts() > 1 ? "" : fmt::format(" ({})", sweep.axis_sizes()[i]));
  if (!sweep.title().empty()) fmt::print("{}\n", printable(sweep.title()));
  fmt::print("tuples         {}\naxes           {}{}\n", sweep.size(), axes.empty() ? "none" : axes,
             sweep.parts() > 1 ? fmt::format(", in {} tables [[sweep]]", sweep.parts()) : "");
  fmt::print("core time      {}\n", duration(plan.core_seconds));
  fmt::print("longest tuple  {} (row {})\n", duration(plan.longest_seconds), plan.longest_row);
  fmt::print("makespan       {} on {} {}, no schedule ends before {}\n", duration(plan.makespan_seconds), ranks,
             ranks == 1 ? "rank" : "ranks", duration(plan.lower_bound_seconds));
  fmt::print("ranks of use   up to {}\n", plan.useful_ranks);
  fmt::print("first row      {} after the start\n", duration(plan.needs.seconds_before));
  fmt::print("memory         {} on rank 0{}\n", bytes(plan.needs.manager_bytes),
             ranks > 1 ? fmt::format(", {} on each other rank", bytes(plan.needs.rank_bytes)) : "");
  fmt::print("disk           {}\n", bytes(plan.needs.disk_bytes));
  if (plan.measured) print_measured(*plan.measured);
  if (plan.sampled) fmt::print("Times are estimates from a sample of {} tuples.\n", samples);
}

void print_json(const Sweep& sweep, const Plan& plan, int ranks) {
  auto axes = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < sweep.axes().size(); ++i)
    axes.push_back({{"name", sweep.axes()[i]}, {"size", sweep.axis_sizes()[i]}});
  const nlohmann::ordered_json document = {
      {"title", sweep.title()},
      {"spec_hash", fmt::format("{:016x}", sweep.hash())},
      {"tuples", sweep.size()},
      {"axes", axes},
      {"ranks", ranks},
      {"core_seconds", plan.core_seconds},
      {"longest_seconds", plan.longest_seconds},
      {"longest_row", plan.longest_row},
      {"lower_bound_seconds", plan.lower_bound_seconds},
      {"makespan_seconds", plan.makespan_seconds},
      {"estimated_from_sample", plan.sampled},
      {"useful_ranks", plan.useful_ranks},
      {"seconds_before_first_row", plan.needs.seconds_before},
      {"manager_bytes", plan.needs.manager_bytes},
      {"rank_bytes", plan.needs.rank_bytes},
      {"disk_bytes", plan.needs.disk_bytes},
      {"refused", plan.refused.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(plan.refused)},
      {"measured", measured_json(plan.measured)}};
  fmt::print("{}\n", document.dump(2));
}

int plan(const PlanOptions& options) {
  const Sweep sweep = Sweep::load(options.spec, study_sections, options.settings);
  const Plan result = plan_of(sweep, options.ranks, options.measure);
  if (!result.refused.empty()) fmt::print(stderr, "sigmasweep: 'run' would refuse it: {}\n", result.refused);
  for (const std::string& remark : remarks_on(sweep)) fmt::print(stderr, "sigmasweep: {}\n", remark);
  if (options.json)
    print_json(sweep, result, options.ranks);
  else
    print_text(sweep, result, options.ranks);
  return 0;
}

void declare(OptionSet& set, PlanOptions& options) {
  set.add({"spec", "The sweep spec, a TOML file", "SPEC.toml"}, options.spec);
  add_settings(set, options.settings);
  set.add({"--ranks", "Number of MPI ranks", "R"}, options.ranks, {1, 1 << 20});
  set.add({"--measure", "Compute so many rows, say how their times compare with the predicted ones, and correct these",
           "N"},
          options.measure, {1, 100'000});
  set.add_flag("--json", "One JSON document; times in seconds", options.json);
}

}  // namespace

Command plan_command() {
  return make_command(
      "plan", "Check a sweep spec and predict its computing time; without --measure nothing is run",
      "\nA parameter in [sweep] is a value; an expression of others; a list; a range { from, to, count, scale };\n"
      "or a sample { sample, from, to, count, seed, scale }. 'sigmasweep help spec' explains them.\n\n"
      "  sigmasweep plan fig2a.toml --ranks 64",
      declare, plan);
}

}  // namespace sigmasweep
