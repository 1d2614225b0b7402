#include "solve/exact/linear/side_by_side/isolated.hpp"

#include <algorithm>
#include <bit>

namespace sigmasweep::side_by_side {
namespace {

using State = ContactState<double>;

constexpr double inertia(int k) { return k == 0 ? 1.0 : 2.0; }

/// Contact k becomes `now`, and the gaps beside it receive the difference over its inertia.
void replace(LaneState::Numbers& x, LaneState::Numbers& u, int N, int k, const State& now) {
  const double share = 1.0 / inertia(k), push_x = share * (x[k] - now.x), push_u = share * (u[k] - now.u);
  for (const int gap : {k - 1, k + 1}) {
    if (gap < 0 || gap >= N) continue;
    x[gap] += push_x;
    u[gap] += push_u;
  }
  x[k] = now.x;
  u[k] = now.u;
}

using Wide = long double;

ContactTimes times_of(Wide K, Wide C, Wide inertia, Wide step) {
  const BinaryContact<Wide> law(K * step * step, C * step, inertia);
  const ContactState<Wide> start{0, 1};
  return {double(-law.until_end(start).uu), double(law.time_left(start)), double(law.deepest(start))};
}

BinaryContact<double> contact_of(Wide K, Wide C, double inertia, Wide step) {
  return {double(K * step * step), double(C * step), inertia};
}

bool is_busy(const LaneState& s, int k) { return s.x[k] > 0.0 && s.u[k] < 0.0; }

}  // namespace

Isolated::Isolated(const Column<long double>& c, double step)
    : pair_(contact_of(c.K, c.C, inertia(1), step)),
      wall_(contact_of(c.K_wall, c.C_wall, inertia(0), step)),
      of_pair_(times_of(c.K, c.C, inertia(1), step)),
      at_wall_(times_of(c.K_wall, c.C_wall, inertia(0), step)),
      dashpot_(double(c.C * step)),
      wall_dashpot_(double(c.C_wall * step)) {}

/// A contact lasts D at most, and pushes a gap by (x + u t)/I at most.
bool Isolated::may_jump(const double* x, const double* u, int stride, int N, std::uint64_t closed) const {
  for (; closed != 0; closed &= closed - 1) {
    const int k = std::countr_zero(closed);
    const double share = 1.0 / inertia(k), duration = times(k == 0).duration;
    for (const int gap : {k - 1, k + 1}) {
      if (gap < 0 || gap >= N) continue;
      const double approach = u[gap * stride] + share * u[k * stride];
      if (!(x[gap * stride] + share * x[k * stride] + std::max(approach, 0.0) * duration < 0.0)) return false;
    }
  }
  return true;
}

/// As the flight of a gap beside is uniform, and the bound of its overlap convex, it is enough to look where the busy
/// contacts beside it open.
bool Isolated::to_jumps(LaneState& s) const {
  s.wall_opens = s.wall_opened;
  s.depth = {};
  LaneState::Numbers busy_until{};
  for (int k = 0; k < s.N; ++k)
    if (s.closed[k] && !close_at_once(s, k, busy_until)) return false;
  for (int gap = 0; gap < s.N; ++gap) {
    if (s.closed[gap]) continue;
    for (const int k : {gap - 1, gap + 1}) {
      if (k < 0 || k >= s.N || !s.closed[k]) continue;
      const int other = 2 * gap - k;
      double bound = s.x[gap] + s.u[gap] * busy_until[k];
      if (other >= 0 && other < s.N && s.closed[other])
        bound += std::max(s.x[other] + s.u[other] * busy_until[k], 0.0) / inertia(other);
      if (!(bound < 0.0)) return false;
    }
  }
  return true;
}

/// The disturbance is carried to the opening, where its rate jumps (change_contact()), and back along the flight that
/// follows.
bool Isolated::close_at_once(LaneState& s, int k, LaneState::Numbers& busy_until) const {
  const State entry{s.x[k], s.u[k]};
  if ((k > 0 && s.closed[k - 1]) || entry.x < 0.0 || (entry.x == 0.0 && !(entry.u > 0.0))) return false;
  const auto& law = contact(k);
  const double left = law.time_left(entry);
  const auto map = law.until_end(entry);
  const double rate = map(entry).u;
  if (!(rate < 0.0)) return false;
  State d = map({s.dx[k], s.du[k]});
  d.u += inertia(k) * (k == 0 ? wall_dashpot_ : dashpot_) * d.x;
  s.depth[k] = entry.u > 0.0 ? law.deepest(entry) : 0.0;
  if (k == 0) s.wall_opens = s.clock + left;
  replace(s.dx, s.du, s.N, k, {d.x - d.u * left, d.u});
  replace(s.x, s.u, s.N, k, {-rate * left, rate});
  busy_until[k] = left;
  ++s.contacts;
  return true;
}

void Isolated::to_steps(LaneState& s) const {
  std::array<bool, most_beads> busy{};
  for (int k = 0; k < s.N; ++k) busy[k] = !s.separated && is_busy(s, k);
  if (!busy[0]) s.wall_opened = s.wall_opens;
  for (int k = 0; k < s.N; ++k) {
    s.closed[k] = busy[k];
    if (busy[k]) put_back(s, k);
    if (!busy[k] || s.u[k] <= 0.0) s.x_max = std::max(s.x_max, s.depth[k]);
  }
}

void Isolated::put_back(LaneState& s, int k) const {
  const auto& law = contact(k);
  const auto [restitution, duration, deepest] = times(k == 0);
  const double since = std::max(duration + s.x[k] / s.u[k], 0.0), rate = -s.u[k] / restitution;
  const auto map = law.after(since);
  const double du = -s.du[k] / restitution;
  const double dx = duration * du - (s.dx[k] - s.du[k] * since) / restitution;
  const double damping = inertia(k) * (k == 0 ? wall_dashpot_ : dashpot_);
  replace(s.dx, s.du, s.N, k, map({dx, du - damping * dx}));
  replace(s.x, s.u, s.N, k, map({0.0, rate}));
  --s.contacts;
}

}  // namespace sigmasweep::side_by_side
