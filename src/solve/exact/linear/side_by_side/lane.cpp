#include "solve/exact/linear/side_by_side/lane.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <vector>

#include "assembly/energy_balance.hpp"
#include "base/random.hpp"
#include "solve/exact/linear/side_by_side/motion.hpp"
#include "solve/exact/linear/step_lengths.hpp"
#include "solve/to_si.hpp"

namespace sigmasweep::side_by_side {
namespace {

/// As for columns alone (exact/linear/collision.cpp): one disturbance is one random draw of what the true error is
/// another draw of; and roundings that the disturbance does not know of.
constexpr double safety = 16.0, last_roundings = 8.0, drift = 0.1;

double longest_step(const Column<double>& column) {
  const std::vector<std::uint8_t> closed(column.contacts(), 1);
  return StepLengths<double, false>(column).longest(0, column.contacts() - 1, closed);
}

/// Equal columns have equal noise, whatever their units.
std::uint64_t noise_key(const Column<double>& column) {
  std::uint64_t key = random_bits(static_cast<std::uint64_t>(column.N), 0);
  const auto take = [&key](double number) { key = random_bits(key ^ std::bit_cast<std::uint64_t>(number), 0); };
  for (const double number : {column.gap, column.K, column.C, column.K_wall, column.C_wall}) take(number);
  for (const double gap : column.gaps) take(gap);
  return key;
}

std::uint64_t looks_after(std::int64_t N) { return static_cast<std::uint64_t>(std::max<std::int64_t>(5, N / 8)); }

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
      step_(longest_step(column_)),
      key_(noise_key(column_)),
      step_limit_(static_cast<std::uint64_t>(200 + 20 * parameters.N * parameters.N)),
      next_look_(looks_after(parameters.N)),
      settle_(1e-3 * parameters.tolerance),
      least_(std::numeric_limits<double>::infinity()) {}

LaneState Lane::start() const {
  LaneState s;
  const std::size_t N = column_.contacts();
  for (std::size_t k = 1; k < N; ++k) s.x[k] = -column_.initial_gap(k);
  s.u[0] = column_.speed * step_;
  std::size_t closed = 1;
  s.closed[0] = 1;
  while (closed < N && s.x[closed] == 0.0) s.closed[closed++] = 1;
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

std::uint64_t Lane::noise() { return random_bits(key_, ++steps_); }

bool Lane::ends(const LaneState& state) {
  if (state.separated || steps_ >= step_limit_) return true;
  if (state.contacts < next_look_) return false;
  next_look_ = state.contacts + looks_after(column_.N);
  const auto [disturbance, remaining] = balance(state);
  least_ = std::min(least_, safety * disturbance + remaining);
  settled_ = remaining < settle_;
  return settled_;
}

auto Lane::balance(const LaneState& state) const -> Balance {
  const std::size_t N = column_.contacts();
  const EnergyBalance<double> energy(column_, std::span(state.closed).first(N), std::span(state.x).first(N),
                                     velocities(state.u, N, step_));
  return {energy.change(std::span(state.dx).first(N), velocities(state.du, N, step_)), energy.remaining()};
}

SimulationResult Lane::result(const LaneState& state) {
  Outcome<double> outcome;
  outcome.velocity = velocities(state.u, column_.contacts(), step_);
  outcome.t_k = state.wall_opened * step_;
  outcome.x_max = state.x_max;
  outcome.contacts = state.contacts;
  outcome.end = state.separated ? End::separated : settled_ ? End::settled : End::none;
  outcome.status = outcome.end == End::none ? Status::event_limit : Status::ok;
  SimulationResult c = to_si_result(outcome, parameters_);
  if (c.status != Status::ok) return c;
  const auto [disturbance, remaining] = balance(state);
  least_ = std::min(least_, safety * disturbance + remaining);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double roundings = last_roundings + drift * static_cast<double>(steps_);
  // K_over_m and D_n near critical damping: restitution may be small, and has the roundings of numbers of order one.
  const double size = parameters_.K_over_m > 0.0 ? 1.0 : c.eps_eff;
  c.eps_eff_error = least_ + roundings * epsilon * size + 0.5 * epsilon * c.eps_eff;
  return c;
}

}  // namespace sigmasweep::side_by_side
