#include "engine/report/measured_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "base/thread_clock.hpp"
#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "solve/solvers.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t neighbours = 64;          // that are computed side by side
constexpr double longest_neighbourhood = 0.02;  // s, predicted
constexpr double longest_measured = 0.2;        // s, needed

struct Measurement {
  double predicted = 0.0, needed = 0.0;  ///< s, of `rows` rows
  std::size_t rows = 0;
  bool given_up = false;
};

/// Computes the first of these tasks, if it goes side by side with the next ones.
Measurement measure(const Sweep& sweep, std::span<const ScheduledTask> tasks, double limit) {
  std::vector<Parameters> parameters;
  std::vector<double> predicted;
  Measurement found;
  for (const ScheduledTask& task : tasks.first(std::min(tasks.size(), neighbours))) {
    const Parameters p = sweep.at(task.row);
    const bool is_first = parameters.empty();
    if (!is_first && (!solver_of(p).run_many || found.predicted + task.predicted_seconds > longest_neighbourhood))
      break;
    parameters.push_back(p);
    predicted.push_back(task.predicted_seconds);
    found.predicted += task.predicted_seconds;
    if (!solver_of(p).run_many) break;
  }
  std::vector<SimulationResult> results(parameters.size());
  const double start = thread_seconds();
  simulate_together(parameters, results);
  found.predicted = 0.0;
  for (std::size_t i = 0; i < results.size() && (i == 0 || found.needed < longest_measured); ++i) {
    ComputeBudget budget(limit);
    if (results[i].status == Status::not_run) results[i] = simulate(parameters[i], &budget);
    found.given_up = found.given_up || budget.was_over();
    found.predicted += predicted[i];
    found.needed = thread_seconds() - start;
    ++found.rows;
  }
  return found;
}

}  // namespace

double MeasuredCost::quantile(double q) const {
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(ratios.size())));
  return ratios[std::clamp<std::size_t>(rank, 1, ratios.size()) - 1];
}

MeasuredCost measure_cost(const Sweep& sweep, std::vector<ScheduledTask> tasks, std::size_t count, double limit) {
  std::ranges::sort(tasks, [](const ScheduledTask& a, const ScheduledTask& b) {
    return a.predicted_seconds != b.predicted_seconds ? a.predicted_seconds > b.predicted_seconds : a.row < b.row;
  });
  double total = 0.0;
  for (const ScheduledTask& task : tasks) total += task.predicted_seconds;
  count = std::min(count, tasks.size());
  MeasuredCost cost;
  measure(sweep, std::span(tasks).last(1), limit);  // code and data are in the caches from now on
  double until = 0.0;                               // predicted time of the tasks before the next one
  for (std::size_t part = 0, next = 0; part < count; ++part) {
    const double turn = 0.6180339887498949 * static_cast<double>(part);  // golden ratio: not in step with the axes
    const double wanted = (static_cast<double>(part) + turn - std::floor(turn)) * total / static_cast<double>(count);
    while (next + 1 < tasks.size() && until + tasks[next].predicted_seconds <= wanted)
      until += tasks[next++].predicted_seconds;
    const Measurement found = measure(sweep, std::span(tasks).subspan(next), limit);
    cost.ratios.push_back(found.needed / found.predicted);
    cost.longest_seconds = std::max(cost.longest_seconds, found.needed / static_cast<double>(found.rows));
    cost.given_up += found.given_up;
  }
  const auto n = static_cast<double>(count);
  cost.mean = std::accumulate(cost.ratios.begin(), cost.ratios.end(), 0.0) / n;
  double squares = 0.0;
  for (const double ratio : cost.ratios) squares += (ratio - cost.mean) * (ratio - cost.mean);
  cost.standard_error = count > 1 ? std::sqrt(squares / (n * (n - 1.0))) : std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(cost.ratios);
  return cost;
}

}  // namespace sigmasweep
