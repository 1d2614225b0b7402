#include "solve/exact/linear/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "numerics/double_double.hpp"
#include "solve/exact/linear/column.hpp"
#include "solve/exact/linear/error_bar.hpp"
#include "solve/to_si.hpp"

namespace sigmasweep {

template <class Real>
Outcome<Real> exact_collision(const Column<Real>& column, const RunLimits& limits) {
  if (!column.exponents.linear()) throw std::invalid_argument("exact_collision: not the linear law");
  if (column.is_uniform()) return ExactColumn<Real, 0, false>(column, limits).run();
  return ExactColumn<Real, 0, true>(column, limits).run();
}

template <class Real>
Outcome<Real> exact_collision_from(const Column<Real>& column, std::span<const Real> rates, const RunLimits& limits) {
  if (!column.exponents.linear()) throw std::invalid_argument("exact_collision_from: not the linear law");
  if (rates.size() != column.contacts()) throw std::invalid_argument("exact_collision_from: one rate a contact");
  const auto run = [&](auto exact) {
    exact.start_from(rates);
    return exact.run();
  };
  return column.is_uniform() ? run(ExactColumn<Real, 0, false>(column, limits))
                             : run(ExactColumn<Real, 0, true>(column, limits));
}

template Outcome<double> exact_collision(const Column<double>&, const RunLimits&);
template Outcome<long double> exact_collision(const Column<long double>&, const RunLimits&);
template Outcome<Quad> exact_collision(const Column<Quad>&, const RunLimits&);
template Outcome<double> exact_collision_from(const Column<double>&, std::span<const double>, const RunLimits&);
template Outcome<long double> exact_collision_from(const Column<long double>&, std::span<const long double>,
                                                   const RunLimits&);

namespace {

using error_bar::safety;
/// From this tolerance on short series are tried first: two thirds of the time, and bars of about 1e-5.
constexpr double loose = 1e-4;
/// The work (ExactColumn::work) that a wide type does in about a second, up to which it is tried.
template <class Wide>
constexpr std::uint64_t work_limit = 1'000'000;
template <>
constexpr std::uint64_t work_limit<DoubleDouble> = 300'000;
template <>
constexpr std::uint64_t work_limit<Quad> = 50'000;

/// How many times finer than double's a type's roundings are.
template <class Wide>
double gain() {
  return std::numeric_limits<double>::epsilon() / static_cast<double>(std::numeric_limits<Wide>::epsilon());
}

/// What a run in doubles has to say on whether a wider type is worth a try, and to twins of the column.
struct Effort {
  std::uint64_t work = 0;
  double bar_in_long_double = 0.0, bar_in_double_double = 0.0, bar_in_quad = 0.0;  ///< to be expected of them
  std::vector<double> velocity;
};

/// The collision computed in `Real`, its error bar included.
template <class Real, bool HasUnequalMasses, int Order>
SimulationResult computed_from(const Column<Real>& column, const Parameters& p, const RunLimits& limits,
                               Effort& effort) {
  using Exact = ExactColumn<Real, error_bar::draws, HasUnequalMasses, Order>;
  Exact exact(column, limits);
  const Outcome<Real> outcome = exact.run();
  const auto expected = [&](double gain) { return static_cast<double>(exact.error(safety / gain)); };
  effort = {exact.work(), expected(gain<long double>()), expected(gain<DoubleDouble>()), expected(gain<Quad>()), {}};
  for (const Real& v : outcome.velocity) effort.velocity.push_back(static_cast<double>(v));
  SimulationResult c = to_si_result<Real>(outcome, p, column.mass);
  if (c.status != Status::ok) return c;
  double roundings = error_bar::last_roundings + error_bar::drift * double(exact.work()) / double(p.N);
  if constexpr (HasUnequalMasses) roundings += error_bar::shares * double(outcome.contacts) / double(p.N);
  const Real size = error_bar::size(p, c.eps_eff);
  const Real error = exact.error(safety) + Real(roundings) * Exact::local_error() * size;
  c.eps_eff_error = static_cast<double>(error) + 0.5 * std::numeric_limits<double>::epsilon() * c.eps_eff;
  set_errors_of_motion(
      c, static_cast<double>(exact.velocity_error(safety) + Real(roundings) * Exact::local_error() * size));
  return c;
}

template <class To, class From>
Column<To> converted(const Column<From>& c) {
  const auto each = [](const std::vector<From>& numbers) {
    std::vector<To> all;
    for (const From& number : numbers) all.push_back(To(number));
    return all;
  };
  return {.N = c.N,
          .gap = To(c.gap),
          .speed = To(c.speed),
          .tc = To(c.tc),
          .eps = To(c.eps),
          .eps_wall = To(c.eps_wall),
          .K = To(c.K),
          .C = To(c.C),
          .K_wall = To(c.K_wall),
          .C_wall = To(c.C_wall),
          .exponents = c.exponents,
          .mass = each(c.mass),
          .gaps = each(c.gaps)};
}

template <class Real>
Column<Real> column_of(const Parameters& p) {
  if constexpr (std::is_same_v<Real, DoubleDouble>)
    return converted<DoubleDouble>(reduced_column<Quad>(p));
  else
    return reduced_column<Real>(p);
}

template <class Real, int Order = TaylorOrder<Real>::value>
SimulationResult computed_in(const Parameters& p, const RunLimits& limits, Effort& effort) {
  const Column<Real> column = column_of<Real>(p);
  if (column.is_uniform()) return computed_from<Real, false, Order>(column, p, limits, effort);
  return computed_from<Real, true, Order>(column, p, limits, effort);
}

/// The error bars from two twins of the column, whose dashpots, gaps and masses differ from its own in the thirteenth
/// digit, or the fourteenth for tolerances that need it. In a long tail of contacts that carry next to no energy a
/// linearised disturbance grows without end, and says nothing; the twins go their own way there, too, but end where the
/// energy lets them.
SimulationResult with_errors_from_twins(SimulationResult c, const Parameters& p, const RunLimits& limits,
                                        std::span<const double> velocity) {
  double largest = 0.0, farthest = 0.0;
  const double little = std::clamp(0.1 * p.tolerance, 1e-14, 1e-13);
  for (const double change : {-little, little}) {
    Column<double> twin = reduced_column<double>(p);
    twin.gap *= 1.0 - change;
    twin.C *= 1.0 + change;
    twin.C_wall *= 1.0 + change;
    for (double& gap : twin.gaps) gap *= 1.0 - change;
    for (std::size_t i = 0; i < twin.mass.size(); ++i) twin.mass[i] *= 1.0 + (i % 2 == 0 ? change : -change);
    const Outcome<double> outcome = exact_collision(twin, limits);
    if (outcome.status != Status::ok) return c;
    largest = std::max(largest, std::abs(energies<double>(outcome.velocity, 1.0, twin.mass).eps_eff - c.eps_eff));
    farthest = std::max(farthest, distance<double>(outcome.velocity, velocity, twin.mass));
  }
  SimulationResult by_twins = c;
  set_errors_of_motion(by_twins, safety * farthest + velocity_left(c.eps_eff, limits.settle));
  c.eps_eff_error = std::min(c.eps_eff_error, safety * largest + limits.settle);
  c.Er_Ef_error = std::min(c.Er_Ef_error, by_twins.Er_Ef_error);
  c.v_cm_error = std::min(c.v_cm_error, by_twins.v_cm_error);
  return c;
}

}  // namespace

SimulationResult simulate_exact(const Parameters& p, ComputeBudget* budget) {
  RunLimits limits;
  limits.budget = budget;
  limits.settle = 1e-3 * p.tolerance;
  Effort effort;
  if (p.tolerance >= loose) {
    const SimulationResult quick = computed_in<double, low_order>(p, limits, effort);
    if (quick.status == Status::ok && quick.eps_eff_error <= p.tolerance) return quick;
  }
  SimulationResult c = computed_in<double>(p, limits, effort);
  if (c.status != Status::ok || c.eps_eff_error <= p.tolerance) return c;

  c = with_errors_from_twins(c, p, limits, effort.velocity);
  if (c.eps_eff_error <= p.tolerance) return c;

  const auto meets_it_in = [&]<class Wide>(double expected_bar, Wide) {
    if (!(expected_bar <= p.tolerance) || effort.work > work_limit<Wide>) return false;
    Effort of_no_matter;
    const SimulationResult wide = computed_in<Wide>(p, limits, of_no_matter);
    if (wide.status == Status::ok && wide.eps_eff_error < c.eps_eff_error) c = wide;
    return c.eps_eff_error <= p.tolerance;
  };
  if (meets_it_in(effort.bar_in_long_double, 0.0L) || meets_it_in(effort.bar_in_double_double, DoubleDouble()) ||
      meets_it_in(effort.bar_in_quad, Quad()))
    return c;
  c.eps_eff_error = std::min(1.0, c.eps_eff_error);
  c.status = Status::tolerance_missed;
  return c;
}

void observe_exact(const Column<double>& column, Samples& samples) {
  const RunLimits limits{.settle = 0.0};  // to the last sample
  if (column.is_uniform())
    ExactColumn<double, 0, false>(column, limits).run(samples);
  else
    ExactColumn<double, 0, true>(column, limits).run(samples);
}

}  // namespace sigmasweep
