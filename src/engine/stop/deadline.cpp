#include "engine/stop/deadline.hpp"

#include <algorithm>
#include <cmath>

namespace sigmasweep {
namespace {

constexpr double step = 0.05, quantile = 0.95;
constexpr double min_ratio = 0.2;  // however pessimistic the cost model was so far

}  // namespace

void CostFactor::learn(const Timing& row) {
  if (!(row.predicted_time > 0.0) || !(row.run_time > 0.0)) return;
  const double ratio = std::max(row.run_time / row.predicted_time, min_ratio);
  weight_[static_cast<int>(std::ceil(std::log(ratio) / std::log1p(step)))] += row.predicted_time;
  total_ += row.predicted_time;
  if (total_ > 1.02 * total_at_update_) update();  // rows by the hundred thousand change little each
}

void CostFactor::update() {
  total_at_update_ = total_;
  double above = 0.0;
  for (auto it = weight_.rbegin(); it != weight_.rend(); ++it) {
    above += it->second;
    factor_ = std::pow(1.0 + step, it->first);
    if (above > (1.0 - quantile) * total_) return;
  }
}

double Deadline::max_seconds() const { return std::chrono::duration<double>(end_ - Clock::now()).count() / factor(); }

double time_for_the_end(double seconds, double table_bytes) {
  constexpr double bytes_per_second = 20e6;
  return std::max(std::min(10.0, 0.1 * seconds), table_bytes / bytes_per_second);
}

}  // namespace sigmasweep
