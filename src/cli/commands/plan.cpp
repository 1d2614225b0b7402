#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/printable.hpp"
#include "cli/command.hpp"
#include "cli/settings_option.hpp"
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
  bool json = false;
};

struct Plan {
  double core_seconds = 0.0, longest_seconds = 0.0, lower_bound_seconds = 0.0, makespan_seconds = 0.0;
  std::uint64_t longest_row = 0;
  bool sampled = false;
};

constexpr std::uint64_t max_rows = 1'000'000, samples = 200'000;

/// The plan from the predicted times of all rows, or for a huge sweep from a sample of evenly spread rows.
Plan plan_of(const Sweep& sweep, int ranks) {
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
  const ScheduledTask longest = *std::ranges::max_element(tasks, {}, &ScheduledTask::predicted_seconds);
  plan.longest_seconds = longest.predicted_seconds;
  plan.longest_row = longest.row;
  plan.core_seconds = part * sum;
  plan.lower_bound_seconds = std::max(plan.core_seconds / ranks, plan.longest_seconds);
  if (!plan.sampled)
    plan.makespan_seconds = Schedule(std::move(tasks), ranks).predicted_makespan();
  else
    plan.makespan_seconds = plan.lower_bound_seconds + plan.longest_seconds * (ranks - 1) / ranks;  // Graham 1969
  return plan;
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", 1e3 * seconds);
  if (seconds < 120.0) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.3g} min", seconds / 60.0);
  return fmt::format("{:.4g} h", seconds / 3600.0);
}

void print_text(const Sweep& sweep, const Plan& plan, int ranks) {
  std::string axes;
  for (std::size_t i = 0; i < sweep.axes().size(); ++i)
    axes += fmt::format("{}{} ({})", i ? ", " : "", sweep.axes()[i], sweep.axis_sizes()[i]);
  if (!sweep.title().empty()) fmt::print("{}\n", printable(sweep.title()));
  fmt::print("tuples         {}\naxes           {}\n", sweep.size(), axes.empty() ? "none" : axes);
  fmt::print("core time      {}\n", duration(plan.core_seconds));
  fmt::print("longest tuple  {} (row {})\n", duration(plan.longest_seconds), plan.longest_row);
  fmt::print("makespan       {} on {} {}, no schedule ends before {}\n", duration(plan.makespan_seconds), ranks,
             ranks == 1 ? "rank" : "ranks", duration(plan.lower_bound_seconds));
  if (plan.sampled) fmt::print("Times are estimates from a sample of {} tuples.\n", samples);
}

void print_json(const Sweep& sweep, const Plan& plan, int ranks) {
  auto axes = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < sweep.axes().size(); ++i)
    axes.push_back({{"name", sweep.axes()[i]}, {"size", sweep.axis_sizes()[i]}});
  const nlohmann::ordered_json document = {{"title", sweep.title()},
                                           {"spec_hash", fmt::format("{:016x}", sweep.hash())},
                                           {"tuples", sweep.size()},
                                           {"axes", axes},
                                           {"ranks", ranks},
                                           {"core_seconds", plan.core_seconds},
                                           {"longest_seconds", plan.longest_seconds},
                                           {"longest_row", plan.longest_row},
                                           {"lower_bound_seconds", plan.lower_bound_seconds},
                                           {"makespan_seconds", plan.makespan_seconds},
                                           {"estimated_from_sample", plan.sampled}};
  fmt::print("{}\n", document.dump(2));
}

int plan(const PlanOptions& options) {
  const Sweep sweep = Sweep::load(options.spec, study_sections, options.settings);
  const Plan result = plan_of(sweep, options.ranks);
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
  set.add_flag("--json", "One JSON document; times in seconds", options.json);
}

}  // namespace

Command plan_command() {
  return make_command(
      "plan", "Check a sweep spec and predict its computing time; nothing is run",
      "\nA parameter in [sweep] is a value; a list; a range { from, to, count, scale = \"linear\" | \"log\" };\n"
      "or a sample { sample = \"uniform\" | \"log-uniform\" | \"sobol\" | \"latin-hypercube\", from, to,\n"
      "count, seed, scale }, where scale is for the last two.\n\n"
      "  sigmasweep plan fig2a.toml --ranks 64",
      declare, plan);
}

}  // namespace sigmasweep
