#include "solve/exact/linear/side_by_side/isolated.hpp"

#include <array>
#include <bit>

namespace sigmasweep::side_by_side {
namespace {

using State = ContactState<double>;
using Wide = long double;

/// Contact k becomes `now`, and the gaps beside it receive their shares of the difference.
template <class Numbers>
void replace(Numbers& x, Numbers& u, int N, int k, const IsolatedContact& contact, const State& now) {
  using Number = typename Numbers::value_type;
  const double lost_x = x[k] - now.x, lost_u = u[k] - now.u;
  const auto push = [&](int gap, double share) {
    x[gap] += static_cast<Number>(share * lost_x);
    u[gap] += static_cast<Number>(share * lost_u);
  };
  if (k > 0) push(k - 1, contact.share_below);
  if (k + 1 < N) push(k + 1, contact.share_above);
  x[k] = static_cast<Number>(now.x);
  u[k] = static_cast<Number>(now.u);
}

IsolatedContact contact_of(const Column<Wide>& c, std::size_t k, Wide step) {
  const Wide K = c.spring(k) * step * step, C = c.dashpot(k) * step, inertia = c.inertia(k);
  const Wide above = c.inverse_mass(k);
  const BinaryContact<Wide> law(K, C, inertia);
  const ContactState<Wide> start{0, 1};
  return {.law = {double(K), double(C), double(inertia)},
          .dashpot = double(C),
          .inertia = double(inertia),
          .inverse_mass = double(above),
          .share_below = k == 0 ? 0.0 : double(c.inverse_mass(k - 1) / inertia),
          .share_above = double(above / inertia),
          .restitution = double(-law.until_end(start).uu),
          .duration = double(law.time_left(start)),
          .deepest = double(law.deepest(start))};
}

bool is_busy(const LaneState& s, int k) { return s.x[k] > 0.0 && s.u[k] < 0.0; }

}  // namespace

Isolated::Isolated(const Column<Wide>& column, double step) : last_(column.is_uniform() ? 1 : column.contacts() - 1) {
  for (std::size_t k = 0; k <= last_; ++k) contacts_.push_back(contact_of(column, k, step));
}

/// A contact lasts D at most, and pushes a gap by its share of x + u t at most.
bool Isolated::may_jump(const double* x, const double* u, int stride, int N, std::uint64_t closed) const {
  for (; closed != 0; closed &= closed - 1) {
    const int k = std::countr_zero(closed);
    const IsolatedContact& c = contact(k);
    const auto stays_open = [&](int gap, double share) {
      const double approach = u[gap * stride] + share * u[k * stride];
      return x[gap * stride] + share * x[k * stride] + std::max(approach, 0.0) * c.duration < 0.0;
    };
    if (k > 0 && !stays_open(k - 1, c.share_below)) return false;
    if (k + 1 < N && !stays_open(k + 1, c.share_above)) return false;
  }
  return true;
}

/// As the flight of a gap beside is uniform, and the bound of its overlap convex, it is enough to look where the busy
/// contacts beside it open.
bool Isolated::to_jumps(LaneState& s) const {
  s.wall_opens = s.wall_opened;
  std::fill_n(s.depth.begin(), s.N, 0.0);
  LaneState::Numbers busy_until;
  std::fill_n(busy_until.begin(), s.N, 0.0);
  for (int k = 0; k < s.N; ++k)
    if (s.closed[k] && !close_at_once(s, k, busy_until)) return false;
  for (int gap = 0; gap < s.N; ++gap) {
    if (s.closed[gap]) continue;
    for (const int k : {gap - 1, gap + 1}) {
      if (k < 0 || k >= s.N || !s.closed[k]) continue;
      const int other = 2 * gap - k;
      double bound = s.x[gap] + s.u[gap] * busy_until[k];
      if (other >= 0 && other < s.N && s.closed[other]) {
        const double share = other > gap ? contact(other).share_below : contact(other).share_above;
        bound += std::max(s.x[other] + s.u[other] * busy_until[k], 0.0) * share;
      }
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
  const IsolatedContact& c = contact(k);
  const double left = c.law.time_left(entry);
  const auto map = c.law.until_end(entry);
  const double rate = map(entry).u;
  if (!(rate < 0.0)) return false;
  for (auto& [dx, du] : s.disturbed) {
    State d = map({dx[k], du[k]});
    d.u += c.inertia * c.dashpot * d.x;
    replace(dx, du, s.N, k, c, {d.x - d.u * left, d.u});
  }
  s.depth[k] = entry.u > 0.0 ? c.law.deepest(entry) : 0.0;
  if (k == 0) s.wall_opens = s.clock + left;
  replace(s.x, s.u, s.N, k, c, {-rate * left, rate});
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
  const IsolatedContact& c = contact(k);
  const double since = std::max(c.duration + s.x[k] / s.u[k], 0.0), rate = -s.u[k] / c.restitution;
  const auto map = c.law.after(since);
  for (auto& [dx, du] : s.disturbed) {
    const double du_then = -du[k] / c.restitution;
    const double dx_then = c.duration * du_then - (dx[k] - du[k] * since) / c.restitution;
    replace(dx, du, s.N, k, c, map({dx_then, du_then - c.inertia * c.dashpot * dx_then}));
  }
  replace(s.x, s.u, s.N, k, c, map({0.0, rate}));
  --s.contacts;
}

}  // namespace sigmasweep::side_by_side
