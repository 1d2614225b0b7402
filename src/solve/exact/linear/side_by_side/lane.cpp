#include "solve/exact/linear/side_by_side/lane.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <vector>

#include "assembly/energy_balance.hpp"
#include "base/random.hpp"
#include "solve/exact/linear/error_bar.hpp"
#include "solve/exact/linear/side_by_side/lanes/motion.hpp"
#include "solve/stop_logic.hpp"
#include "solve/to_si.hpp"

namespace sigmasweep::side_by_side {
namespace {

using error_bar::safety;

/// Equal columns have equal noise, whatever their units.
std::uint64_t noise_key(const Column<double>& column) {
  std::uint64_t key = random_bits(static_cast<std::uint64_t>(column.N), 0);
  const auto take = [&key](double number) { key = random_bits(key ^ std::bit_cast<std::uint64_t>(number), 0); };
  for (const double number : {column.gap, column.K, column.C, column.K_wall, column.C_wall}) take(number);
  for (const double gap : column.gaps) take(gap);
  return key;
}

std::vector<double> velocities(const LaneState::Numbers& rates, std::size_t N, double step) {
  std::vector<double> v(N);
  double sum = 0.0;
  for (std::size_t k = 0; k < N; ++k) v[k] = sum -= rates[k] / step;
  return v;
}

}  // namespace

Lane::Lane(const Parameters& parameters)
    : parameters_(parameters),
      column_(reduced_column<double>(parameters)),
      law_(law_of(parameters)),
      key_(noise_key(column_)),
      step_limit_(static_cast<std::uint64_t>(200 + 20 * parameters.N * parameters.N)),
      between_looks_(SettleSchedule::contacts_between(column_.contacts())),
      next_look_(between_looks_),
      settle_(1e-3 * parameters.tolerance) {}

LaneState Lane::start() const {
  LaneState s;
  const std::size_t N = column_.contacts();
  for (std::size_t k = 1; k < N; ++k) s.x[k] = -column_.initial_gap(k);
  s.N = static_cast<int>(N);
  s.u[0] = column_.speed * law_->step;
  for (std::size_t k = 0; k < N && s.x[k] == 0.0 && !starts_by_jumps(); ++k) s.closed[k] = 1;
  // The gaps are rounded numbers: all of them the same way, as sigma is, or each for itself.
  const double widest =
      column_.gaps.empty() ? column_.gap : *std::max_element(column_.gaps.begin(), column_.gaps.end());
  std::uint64_t signs = random_bits(key_, 0);
  for (std::size_t k = 1; k < N; ++k) {
    s.dx[k] = (signs & 1 ? rounding : -rounding) * widest;
    if (!column_.gaps.empty()) signs >>= 1;
  }
  return s;
}

bool Lane::starts_by_jumps() const { return column_.N == 1 || column_.initial_gap(1) > 0.0; }

std::uint64_t Lane::noise() { return random_bits(key_, ++steps_); }

/// If velocities approach by u, at least u^2/2 of |v|^2 <= N will be lost: sqrt(E/E_0) falls by u^2/(4 N) or more. A
/// bar with more than the tolerance left to dissipate is of no use.
bool Lane::wants_look(std::uint64_t contacts, double approach) {
  if (steps_ >= step_limit_) return true;
  const double u = approach / law_->step;
  if (u * u <= parameters_.tolerance * 4.0 * static_cast<double>(column_.N)) return true;
  next_look_ = look_after(contacts);
  return false;
}

bool Lane::ends(const LaneState& state) {
  const bool over = state.separated || steps_ >= step_limit_;
  // Nothing is left at the end: if it is time for a look, the column has settled.
  const bool last_look = state.separated && state.contacts % between_looks_ == 0;
  if (!is_due(state.contacts) && !last_look) return over;
  next_look_ = look_after(state.contacts);
  const Balance now = balance(state);
  note(now);
  settled_ = now.remaining < settle_;
  return settled_ || over;
}

auto Lane::balance(const LaneState& state) const -> Balance {
  const std::size_t N = column_.contacts();
  const EnergyBalance<double> energy(column_, std::span(state.closed).first(N), std::span(state.x).first(N),
                                     velocities(state.u, N, law_->step));
  const auto outlook = energy.outlook();
  const std::span<const double> dx = std::span(state.dx).first(N);
  const std::vector<double> dv = velocities(state.du, N, law_->step);
  return {.disturbance = energy.change(dx, dv),
          .remaining = outlook.decrease,
          .distance = energy.distance(dx, dv),
          .ahead = 2.0 * outlook.final_distance,
          .present = outlook.final_distance + outlook.present_distance};
}

void Lane::note(const Balance& now) {
  least_ = std::min(least_, safety * now.disturbance + now.remaining);
  least_of_velocity_ = std::min(least_of_velocity_, safety * now.distance + now.ahead);
}

SimulationResult Lane::result(const LaneState& state) {
  Outcome<double> outcome;
  outcome.velocity = velocities(state.u, column_.contacts(), law_->step);
  outcome.t_k = state.wall_opened * law_->step;
  outcome.x_max = state.x_max;
  outcome.contacts = state.contacts;
  outcome.end = settled_ ? End::settled : state.separated ? End::separated : End::none;
  outcome.status = outcome.end == End::none ? Status::event_limit : Status::ok;
  SimulationResult c = to_si_result(outcome, parameters_);
  if (c.status != Status::ok) return c;
  const Balance now = balance(state);
  note(now);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double roundings = error_bar::last_roundings + error_bar::drift * static_cast<double>(steps_);
  const double size = error_bar::size(parameters_, c.eps_eff);
  c.eps_eff_error = least_ + roundings * epsilon * size + 0.5 * epsilon * c.eps_eff;
  set_errors_of_motion(c, least_of_velocity_ + now.present + roundings * epsilon * size);
  return c;
}

}  // namespace sigmasweep::side_by_side
