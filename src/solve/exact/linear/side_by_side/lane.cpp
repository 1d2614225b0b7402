#include "solve/exact/linear/side_by_side/lane.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
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
static_assert(disturbances == error_bar::draws);

/// Equal columns have equal noise, whatever their units.
std::uint64_t noise_key(const Column<double>& column) {
  std::uint64_t key = random_bits(static_cast<std::uint64_t>(column.N), 0);
  const auto take = [&key](double number) { key = random_bits(key ^ std::bit_cast<std::uint64_t>(number), 0); };
  for (const double number : {column.gap, column.K, column.C, column.K_wall, column.C_wall}) take(number);
  for (const double gap : column.gaps) take(gap);
  for (const double mass : column.mass) take(mass);
  return key;
}

template <class Numbers>
std::vector<double> velocities(const Numbers& rates, std::size_t N, double step) {
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
      settle_(1e-3 * parameters.tolerance) {
  double largest = 2.0, all = static_cast<double>(column_.N);
  if (!column_.is_uniform()) {
    for (std::size_t k = 0; k < column_.contacts(); ++k) largest = std::max(largest, column_.inertia(k));
    all = std::accumulate(column_.mass.begin(), column_.mass.end(), 0.0);
  }
  least_loss_ = 1.0 / (largest * all);
}

LaneState Lane::start() const {
  LaneState s(static_cast<int>(column_.N));
  const std::size_t N = column_.contacts();
  for (std::size_t k = 1; k < N; ++k) s.x[k] = -column_.initial_gap(k);
  s.u[0] = column_.speed * law_->step;
  for (std::size_t k = 0; k < N && s.x[k] == 0.0 && !starts_by_jumps(); ++k) s.closed[k] = 1;
  // The gaps are rounded numbers: all of them the same way, as sigma is, or each for itself.
  const double widest =
      column_.gaps.empty() ? column_.gap : *std::max_element(column_.gaps.begin(), column_.gaps.end());
  for (int d = 0; d < disturbances; ++d) {
    std::uint64_t signs = noise(d, 0);
    for (std::size_t k = 1; k < N; ++k) {
      s.disturbed[static_cast<std::size_t>(d)].x[k] = static_cast<float>(signs & 1 ? widest : -widest);
      if (!column_.gaps.empty()) signs >>= 1;
    }
  }
  return s;
}

bool Lane::starts_by_jumps() const { return column_.N == 1 || column_.initial_gap(1) > 0.0; }

/// If beads approach by u, at least m_red u^2 of the mass-weighted |v|^2 <= M will be lost: sqrt(E/E_0) falls by half
/// of m_red u^2/M or more. A bar with more than the tolerance left to dissipate is of no use.
bool Lane::wants_look(std::uint64_t contacts, double approach) {
  if (steps_ >= step_limit_) return true;
  const double u = approach / law_->step;
  if (0.5 * least_loss_ * u * u <= parameters_.tolerance) return true;
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
  Balance now{.remaining = outlook.decrease,
              .ahead = 2.0 * outlook.final_distance,
              .present = outlook.final_distance + outlook.present_distance};
  for (const auto& [dx, du] : state.disturbed) {
    const std::vector<double> x(dx.begin(), dx.begin() + state.N);
    const std::vector<double> v = velocities(du, N, law_->step);
    now.disturbance = std::max(now.disturbance, rounding * energy.change(x, v));
    now.distance = std::max(now.distance, rounding * energy.distance(x, v));
  }
  return now;
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
  SimulationResult c = to_si_result<double>(outcome, parameters_, column_.mass);
  if (c.status != Status::ok) return c;
  const Balance now = balance(state);
  note(now);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double roundings = error_bar::last_roundings + error_bar::drift * static_cast<double>(steps_);
  if (!column_.is_uniform())
    roundings += error_bar::shares * static_cast<double>(outcome.contacts) / static_cast<double>(column_.N);
  const double size = error_bar::size(parameters_, c.eps_eff);
  c.eps_eff_error = least_ + roundings * epsilon * size + 0.5 * epsilon * c.eps_eff;
  set_errors_of_motion(c, least_of_velocity_ + now.present + roundings * epsilon * size);
  return c;
}

}  // namespace sigmasweep::side_by_side
