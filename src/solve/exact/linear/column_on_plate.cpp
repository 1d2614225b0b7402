#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>

#include "solve/exact/linear/column_impl.hpp"

/// What a vibrated plate adds to the exact solver of the linear law.
namespace sigmasweep {
namespace {

/// A step that goes by RestingCluster is worth this many of the series' steps.
constexpr double worth = 4.0;
constexpr int longest_wait = 16;
/// Beads up to which their modes are worth finding: tenths of a second where masses differ, a hundredth else.
constexpr std::size_t max_beads = 100, max_unequal_beads = 32;

}  // namespace

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
Status ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::why_stop() requires(Ground::moves) {
  return stop_.why_stop(contacts_, work_, 1 + closed_count_);
}

/// load(start + s h) = g - A0 omega^2 sin(omega start + omega h s) as a series in s, for a group that has the lowest
/// bead.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::drive(Group& group,
                                                                         Real& h) requires(Ground::moves) {
  if (group.lo > 0) return group.taylor.drive({}, h);
  h = std::min(h, taylor_reach / ground_.omega);
  const Real phase = ground_.omega * group.start, angle = ground_.omega * h;
  const std::array<Real, 4> derivatives{std::sin(phase), std::cos(phase), -std::sin(phase), -std::cos(phase)};
  std::array<Real, Order - 1> terms;
  Real factor = -ground_.A0 * ground_.omega * ground_.omega;
  for (std::size_t p = 0; p < terms.size(); factor *= angle / Real(++p)) terms[p] = factor * derivatives[p % 4];
  terms[0] += ground_.g;
  group.taylor.drive(terms, h);
}

/// A group of closed contacts from the plate on, with an open one above them or none, as far as it lies still.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
bool ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::begin_rest(Group& group) requires(Ground::moves) {
  if (group.lo > 0 || !(ground_.load(group.start) > 0)) return false;
  std::size_t beads = 0;
  while (beads <= group.hi && closed_[beads]) ++beads;
  if (beads < group.hi || beads == 0 || beads > (HasUnequalMasses ? max_unequal_beads : max_beads)) return false;
  if (on_ground_.wait-- > 0) return false;
  auto& clusters = on_ground_.clusters;
  if (clusters.size() <= beads) clusters.resize(N_ + 1);
  if (!clusters[beads]) clusters[beads] = std::make_unique<RestingCluster>(column_, ground_, beads);
  RestingCluster& cluster = *clusters[beads];
  const Real shortest = worth * std::min(steps_.longest(group.lo, group.hi, closed_), taylor_reach / ground_.omega);
  const Real length = cluster.start(x_, u_, group.start) ? cluster.undisturbed(ground_.period(), shortest) : Real(0);
  if (length < shortest) {
    on_ground_.tries = std::min(2 * on_ground_.tries + 1, longest_wait);
    on_ground_.wait = on_ground_.tries;
    return false;
  }
  on_ground_.wait = on_ground_.tries = 0;
  on_ground_.resting = &cluster;
  work_ += beads;
  group.length = length;
  group.event = false;
  return true;
}

template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
void ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::move_resting(const Real& elapsed) requires(
    Ground::moves) {
  x_max_ = std::max(x_max_, on_ground_.resting->deepest(elapsed));
  on_ground_.resting->evaluate(elapsed, x_, u_);
}

/// int F_0 z0' dt and sum_k int C_k u_k^2 dt from the start of the group's step to `elapsed` later.
template <class Real, int Tangents, bool HasUnequalMasses, int Order, class Ground>
PlateWork ExactColumn<Real, Tangents, HasUnequalMasses, Order, Ground>::work_of(const Group& group,
                                                                                const Real& elapsed) const
    requires(Ground::moves) {
  if (group.resting) return on_ground_.resting->work(elapsed);
  PlateWork work;
  if (group.binary) {
    const std::size_t k = group.contact;
    const auto power = [&](double t) {
      const Real u = laws_.binary(k).after(t)(state(k)).u;
      return laws_.dashpot(k) * u * u;
    };
    work.lost = boost::math::quadrature::gauss<double, 20>::integrate(power, 0.0, elapsed);
    return work;
  }
  using Rule = boost::math::quadrature::gauss<double, 10>;  // a step's series has no more than 2 radians
  const std::size_t n = group.hi - group.lo + 1;
  std::vector<Real> x(n), u(n);
  const auto add = [&](double place, double weight) {
    const Real t = elapsed * 0.5 * (1.0 + place);
    group.taylor.evaluate(0, t / group.taylor.step(), x, u);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = group.lo + i;
      if (!closed_[k]) continue;
      work.lost += weight * laws_.dashpot(k) * u[i] * u[i];
      if (k == 0)
        work.in += weight * (column_.spring(0) * x[0] + laws_.dashpot(0) * u[0]) * ground_.speed(group.start + t);
    }
  };
  for (std::size_t j = 0; j < Rule::abscissa().size(); ++j)
    for (const double sign : {-1.0, 1.0}) add(sign * Rule::abscissa()[j], 0.5 * elapsed * Rule::weights()[j]);
  return work;
}

template class ExactColumn<double, 0, false, TaylorOrder<double>::value, Plate>;
template class ExactColumn<double, 0, true, TaylorOrder<double>::value, Plate>;

}  // namespace sigmasweep
