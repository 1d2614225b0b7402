#include "solve/exact/lattice/cluster.hpp"

#include <algorithm>
#include <cmath>

namespace sigmasweep {
namespace {

constexpr int max_tries = 200;
/// Of the first step that a cluster ever makes, tc.
constexpr double first_span = 0.05;
constexpr double shortest_span = 1e-4;

}  // namespace

template <class Real, class Ground>
LatticeCluster<Real, Ground>::LatticeCluster(const Lattice<Real>& lattice, const Real& accuracy, const Ground& ground,
                                             const Real& resting_overlap, const Real& slowest)
    : lattice_(lattice),
      accuracy_(accuracy),
      resting_overlap_(resting_overlap),
      slowest_(slowest),
      ground_(ground),
      force_(lattice.beads.exponents),
      linear_(lattice.beads.exponents.linear()),
      next_(Real(first_span) * lattice.beads.tc) {}

template <class Real, class Ground>
void LatticeCluster<Real, Ground>::clear() {
  beads_.clear();
  guests_.clear();
  contacts_.clear();
  for (auto* v : {&mass_, &inverse_mass_, &K_, &C_, &C_t_}) v->clear();
  for (auto* v : {&origin_, &q_, &v_}) v->clear();
  next_ = Real(first_span) * lattice_.beads.tc;
}

template <class Real, class Ground>
void LatticeCluster<Real, Ground>::add(std::uint32_t bead, const Vec2<Real>& q, const Vec2<Real>& v) {
  beads_.push_back(bead);
  mass_.push_back(lattice_.mass(bead));
  inverse_mass_.push_back(1 / mass_.back());
  origin_.push_back(q);
  v_.push_back(v);
}

template <class Real, class Ground>
std::uint32_t LatticeCluster<Real, Ground>::add_guest(std::uint32_t bead, const BeadMotion<Real>& motion) {
  mass_.resize(wall() + 1 + guests_.size(), Real(0));
  mass_.push_back(lattice_.mass(bead));
  guests_.push_back(motion);
  return static_cast<std::uint32_t>(mass_.size() - 1);
}

template <class Real, class Ground>
void LatticeCluster<Real, Ground>::add_contact(std::uint32_t first, std::uint32_t second, const Neighbour<Real>& with) {
  const Column<Real>& beads = lattice_.beads;
  const bool at_wall = with.is_wall();
  const Real m = mass_[first], other = at_wall ? Real(0) : mass_[second];
  const Real mean = at_wall ? m : Real(2 * m * other / (m + other));
  contacts_.push_back({first, at_wall ? static_cast<std::uint32_t>(wall()) : second, with});
  K_.push_back(at_wall ? beads.K_wall : beads.K);
  C_.push_back((at_wall ? beads.C_wall : beads.C) * mean);
  C_t_.push_back(lattice_.D_t * mean);
}

/// Positions and velocities of all slots.
template <class Real, class Ground>
void LatticeCluster<Real, Ground>::place_slots(const State& y, const Real& at) {
  const std::size_t n = beads_.size();
  for (std::size_t i = 0; i < n; ++i) {
    q_[i] = origin_[i] + vector(y, 0, i);
    v_[i] = vector(y, 1, i);
  }
  for (std::size_t g = 0; g < guests_.size(); ++g) {
    const BeadState<Real> guest = guests_[g].at(at);
    q_[n + 1 + g] = guest.q;
    v_[n + 1 + g] = guest.v;
  }
}

/// Forces of the linear law, in one pass.
template <class Real, class Ground>
void LatticeCluster<Real, Ground>::add_linear_forces() {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact& c = contacts_[k];
    const auto [gap, n] = c.with.bond.gap_and_normal(q_[c.first] - q_[c.second]);
    const Vec2<Real> w = v_[c.first] - v_[c.second];
    const Real u = -dot(n, w);
    const Vec2<Real> f = (C_[k] * u - K_[k] * gap) * n - C_t_[k] * (w + u * n);
    f_[c.first] += f;
    f_[c.second] -= f;
  }
}

/// Forces of any law, whose normal parts are computed together. Leaves overlaps, their rates and normals.
template <class Real, class Ground>
void LatticeCluster<Real, Ground>::add_forces() {
  const std::size_t count = contacts_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Contact& c = contacts_[k];
    const auto [gap, n] = c.with.bond.gap_and_normal(q_[c.first] - q_[c.second]);
    w_[k] = v_[c.first] - v_[c.second];
    n_[k] = n;
    x_[k] = -gap;
    u_[k] = -dot(n, w_[k]);
    if (Ground::moves && rests_[k] && gap > Real(0)) {
      x_[k] = u_[k] = Real(0);
      w_[k] = {};
    }
  }
  if (linear_)
    for (std::size_t k = 0; k < count; ++k) F_[k] = K_[k] * x_[k] + C_[k] * u_[k];
  else
    force_(count, K_.data(), C_.data(), x_.data(), u_.data(), F_.data());
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2<Real> f = F_[k] * n_[k] - C_t_[k] * (w_[k] + u_[k] * n_[k]);
    f_[contacts_[k].first] += f;
    f_[contacts_[k].second] -= f;
  }
}

template <class Real, class Ground>
void LatticeCluster<Real, Ground>::slopes(const State& y, State& dy, const Real& at) {
  const std::size_t n = beads_.size();
  work_ += contacts_.size() + n;
  place_slots(y, at);
  std::fill(f_.begin(), f_.end(), Vec2<Real>{});
  if (linear_ && !Ground::moves)
    add_linear_forces();
  else
    add_forces();
  std::copy_n(y.begin() + std::ptrdiff_t(2 * n), 2 * n, dy.begin());
  for (std::size_t i = 0; i < n; ++i) {
    dy[2 * (n + i)] = inverse_mass_[i] * f_[i].x;
    dy[2 * (n + i) + 1] = inverse_mass_[i] * f_[i].z;
  }
  if constexpr (Ground::moves) works_of_plate(dy, at);
}

/// Adds the load of the plate, its power, and the power that normal dashpots and tangential forces dissipate.
template <class Real, class Ground>
void LatticeCluster<Real, Ground>::works_of_plate(State& dy, const Real& at) requires(Ground::moves) {
  const std::size_t count = contacts_.size(), n = beads_.size();
  const double load = ground_.load(double(at)), speed = ground_.speed(double(at));
  for (std::size_t i = 0; i < n; ++i) dy[2 * (n + i) + 1] -= load;
  const std::vector<Real> none(count);
  std::vector<Real> elastic(count);
  if (linear_)
    for (std::size_t k = 0; k < count; ++k) elastic[k] = K_[k] * x_[k];
  else
    force_(count, K_.data(), none.data(), x_.data(), u_.data(), elastic.data());
  Real in = 0, lost = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2<Real> sliding = w_[k] + u_[k] * n_[k];
    if (contacts_[k].with.is_wall()) in += (F_[k] * n_[k].z - C_t_[k] * sliding.z) * speed;  // all walls move
    lost += (F_[k] - elastic[k]) * u_[k] + C_t_[k] * dot(sliding, sliding);
  }
  dy[works()] = in;
  dy[works() + 1] = lost;
}

template <class Real, class Ground>
Real LatticeCluster<Real, Ground>::trial(const Real& span) {
  span_ = span;
  const auto system = [this](const State& y, State& dy, const Real& at) { slopes(y, dy, at); };
  const Real error = scheme_.step(system, start_, start_slope_, begin_, span, end_);
  slopes(end_, end_slope_, begin_ + span_);
  return error / accuracy_;
}

/// On a plate, contacts that neither press nor move have no force where they are open: they stay closed, see
/// EventSchedule::open_from().
template <class Real, class Ground>
void LatticeCluster<Real, Ground>::start_slopes() {
  rests_.assign(contacts_.size(), 0);
  slopes(start_, start_slope_, begin_);
  if constexpr (Ground::moves) {
    using std::fabs;
    bool any = false;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      rests_[k] = x_[k] < resting_overlap_ && fabs(u_[k]) < slowest_;
      any = any || rests_[k];
    }
    if (any) slopes(start_, start_slope_, begin_);
  }
}

template <class Real, class Ground>
bool LatticeCluster<Real, Ground>::step(const Real& begin, const Real& longest) {
  using std::pow;
  const std::size_t n = beads_.size();
  begin_ = begin;
  for (State* y : {&start_, &end_, &start_slope_, &end_slope_}) y->assign(4 * n + (Ground::moves ? 2 : 0), Real(0));
  for (std::size_t i = 0; i < n; ++i) {
    start_[2 * (n + i)] = v_[i].x;
    start_[2 * (n + i) + 1] = v_[i].z;
  }
  for (auto* v : {&x_, &u_, &F_}) v->resize(contacts_.size());
  for (auto* v : {&n_, &w_}) v->resize(contacts_.size());
  for (auto* v : {&q_, &v_, &f_}) v->resize(n + 1 + guests_.size());
  start_slopes();
  Real span = std::min(next_, longest);
  for (int tries = 0; tries < max_tries; ++tries) {
    const Real error = trial(span);
    if (error <= 1) {
      next_ = span * std::min(Real(4), Real(0.9) * Real(pow(std::max(error, Real(1e-8)), Real(-0.125))));
      return true;
    }
    span *= error < Real(1e10) ? std::max(Real(0.2), Real(0.9) * Real(pow(error, Real(-0.125)))) : Real(0.1);
  }
  return false;
}

/// Twice as long as what was left of this one. Many things may happen at the same time: not next to nothing.
template <class Real, class Ground>
Real LatticeCluster<Real, Ground>::after_cut(const Real& t) const {
  return std::max(Real(2 * (t - begin_)), Real(shortest_span) * lattice_.beads.tc);
}

template <class Real, class Ground>
void LatticeCluster<Real, Ground>::cut(const Real& t) {
  const Real span = std::max(Real(t - begin_), Real(0));
  if (span == span_) return;  // it ends there
  if (t < end()) next_ = after_cut(t);
  trial(span);
}

template <class Real, class Ground>
BeadState<Real> LatticeCluster<Real, Ground>::at(std::size_t place, const Real& t) const {
  if (t <= begin_) return state(start_, start_slope_, place);
  if (t >= end()) return state(end_, end_slope_, place);
  return motion(place).at(t);
}

template <class Real, class Ground>
BeadState<Real> LatticeCluster<Real, Ground>::slot_state(std::size_t slot, const Real& t) const {
  if (slot < wall()) return at(slot, t);
  return slot == wall() ? BeadState<Real>{} : guests_[slot - wall() - 1].at(t);
}

template <class Real, class Ground>
Motion<Real> LatticeCluster<Real, Ground>::overlap(const Contact& contact, const Real& t) const {
  const BeadState<Real> one = slot_state(contact.first, t), other = slot_state(contact.second, t);
  return -contact.with.bond.gap_of({one.q - other.q, one.v - other.v, one.a - other.a});
}

template <class Real, class Ground>
Real LatticeCluster<Real, Ground>::fastest() const {
  using std::sqrt;
  Real squared = 0;
  for (std::size_t i = 0; i < beads_.size(); ++i) squared = std::max(squared, dot(v_[i], v_[i]));
  return sqrt(squared);
}

template class LatticeCluster<double>;
template class LatticeCluster<long double>;
template class LatticeCluster<double, Plate>;

}  // namespace sigmasweep
