#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "assembly/lattice.hpp"
#include "assembly/neighbours.hpp"
#include "base/vec2.hpp"
#include "contact/contact_law.hpp"
#include "solve/fixed_step/driver.hpp"

namespace sigmasweep {

/// The contacts of a lattice from its neighbour lists, each once: pairs of beads, then walls. Each number of a pair has
/// its own array, so that the loop over pairs vectorises. Time is in steps. Bead i has the components 2 i (x) and 2 i +
/// 1 (z) of the displacement q from its site, of u = q' and of the acceleration. Books: dissipation is computed, too.
template <class Force, bool Uneven, bool Books>
class LatticeContacts {
 public:
  LatticeContacts(const Lattice<double>& lattice, double dt)
      : lattice_(lattice),
        force_(lattice.beads.exponents),
        K_(lattice.beads.K * dt * dt),
        K_wall_(lattice.beads.K_wall * dt * dt),
        C_(lattice.beads.C * dt),
        C_wall_(lattice.beads.C_wall * dt),
        T_(lattice.D_t * dt) {}

  /// Reads the neighbour lists, with the beads at q.
  void list(const LatticeNeighbours<double>& neighbours, const double* q, const double* u);

  /// Computes the accelerations a of all beads by the contacts that are closed at q. Keeps overlaps, forces and
  /// dissipation for the functions below.
  void accelerations(const double* q, const double* u, double* a) {
    pairs(q, u);
    for (Wall& wall : walls_) press(wall, q, u);
    hand_out(a);
  }

  /// Changes of contacts between the last evaluation and the last call of look(). Calls `at_bottom(before, now)` with
  /// the overlaps of each contact with the bottom that has closed or opened.
  template <class AtBottom>
  ContactChanges look(AtBottom&& at_bottom);

  std::size_t size() const { return x_.size(); }
  double deepest() const { return deepest_; }
  /// Twice the elastic energy at the last evaluation. The loop uses local variables only, so that it vectorises.
  double elastic() const {
    const Force force = force_;
    const double K = K_, K_wall = K_wall_;
    const double* x = x_.data();
    const std::size_t pairs = pairs_, count = x_.size();
    double sum = 0.0;
    for (std::size_t c = 0; c < count; ++c)
      if (x[c] > 0.0) sum += force.twice_elastic_energy(c < pairs ? K : K_wall, x[c]);
    return sum;
  }
  /// Energy that the dashpots dissipate per step, at the last evaluation.
  double lost() const requires Books {
    double sum = 0.0;
    for (const double each : lost_) sum += each;
    return sum;
  }
  /// The upward force of the container on the beads at the last evaluation.
  double lift() const {
    double sum = 0.0;
    for (const Wall& wall : walls_) sum += wall.F.z;
    return sum;
  }

  /// Calls with(overlap, rate, speed, elastic, 1/m_red, eps) for each contact at q and u. `speed` is that of the
  /// relative motion, `elastic` twice the elastic energy.
  template <class With>
  void each(const double* q, const double* u, With&& with) const;

 private:
  struct Wall {
    std::uint32_t bead;
    bool bottom;
    Bond<double> bond;
    double C, T;
    Vec2<double> F;
    std::size_t contact;  ///< index in x_; walls come after pairs
  };
  static Vec2<double> of(const double* components, std::size_t bead) {
    return {components[2 * bead], components[2 * bead + 1]};
  }
  void add(std::size_t i, const Neighbour<double>& other);
  void pairs(const double* q, const double* u);
  void press(Wall& wall, const double* q, const double* u);
  void hand_out(double* a) const;

  const Lattice<double>& lattice_;
  Force force_;
  double K_, K_wall_, C_, C_wall_, T_;  ///< for mean beads; T: D_t m_ij
  std::size_t pairs_ = 0;
  std::vector<std::int32_t> i_, j_;  ///< x components of the beads
  std::vector<double> R_x_, R_z_, length_, gap0_, C_ij_, T_ij_;
  std::vector<double> F_x_, F_z_;  ///< on bead i
  std::vector<Wall> walls_;
  std::vector<double> x_, before_, lost_;  ///< of pairs and walls: overlap, overlap at the last look(), dissipation
  double deepest_ = 0.0;
};

template <class Force, bool Uneven, bool Books>
void LatticeContacts<Force, Uneven, Books>::list(const LatticeNeighbours<double>& neighbours, const double* q,
                                                 const double* u) {
  for (auto* each : {&R_x_, &R_z_, &length_, &gap0_, &C_ij_, &T_ij_}) each->clear();
  i_.clear();
  j_.clear();
  walls_.clear();
  for (std::size_t i = 0; i < lattice_.count(); ++i)
    for (const Neighbour<double>& other : neighbours.of(i))
      if (other.is_wall() || other.bead < i) add(i, other);
  pairs_ = i_.size();
  for (auto* each : {&F_x_, &F_z_}) each->assign(pairs_, 0.0);
  for (auto* each : {&x_, &lost_}) each->assign(pairs_ + walls_.size(), 0.0);
  for (std::size_t w = 0; w < walls_.size(); ++w) walls_[w].contact = pairs_ + w;
  pairs(q, u);
  for (Wall& wall : walls_) press(wall, q, u);
  before_ = x_;
}

template <class Force, bool Uneven, bool Books>
void LatticeContacts<Force, Uneven, Books>::add(std::size_t i, const Neighbour<double>& other) {
  const double m = lattice_.mass(i);
  if (other.is_wall()) {
    walls_.push_back({static_cast<std::uint32_t>(i),
                      other.bead == Neighbour<double>::bottom,
                      other.bond,
                      C_wall_ * m,
                      T_ * m,
                      {},
                      0});
    return;
  }
  i_.push_back(static_cast<std::int32_t>(2 * i));
  j_.push_back(static_cast<std::int32_t>(2 * other.bead));
  R_x_.push_back(other.bond.R.x);
  R_z_.push_back(other.bond.R.z);
  length_.push_back(other.bond.length);
  gap0_.push_back(other.bond.gap0);
  if constexpr (Uneven) {
    const double n = lattice_.mass(other.bead), m_ij = 2.0 * m * n / (m + n);
    C_ij_.push_back(C_ * m_ij);
    T_ij_.push_back(T_ * m_ij);
  }
}

/// Overlaps and forces of pairs, Eqs. (3) and (4): F = K x^(1+beta) + C x^gamma x' along n, and -T (w - (w.n) n), with
/// the velocity w of bead i relative to bead j; x' = -w.n. The gap is that of Bond.
template <class Force, bool Uneven, bool Books>
void LatticeContacts<Force, Uneven, Books>::pairs(const double* q, const double* u) {
  const std::int32_t *i = i_.data(), *j = j_.data();
  const double *R_x = R_x_.data(), *R_z = R_z_.data(), *length = length_.data(), *gap0 = gap0_.data();
  [[maybe_unused]] const double *C_ij = C_ij_.data(), *T_ij = T_ij_.data();
  double *F_x = F_x_.data(), *F_z = F_z_.data(), *x = x_.data();
  [[maybe_unused]] double* lost = lost_.data();
  const double K = K_, C_mean = C_, T_mean = T_;
  const Force force = force_;
  const std::size_t count = pairs_;
#pragma GCC ivdep
  for (std::size_t p = 0; p < count; ++p) {
    const std::int32_t a = i[p], b = j[p];
    const double q_x = q[a] - q[b], q_z = q[a + 1] - q[b + 1], w_x = u[a] - u[b], w_z = u[a + 1] - u[b + 1];
    const double r_x = R_x[p] + q_x, r_z = R_z[p] + q_z, distance = std::sqrt(r_x * r_x + r_z * r_z);
    const double further = ((R_x[p] + r_x) * q_x + (R_z[p] + r_z) * q_z) / (distance + length[p]);
    const double overlap = -(gap0[p] + further);
    const double inverse = 1.0 / distance, n_x = r_x * inverse, n_z = r_z * inverse;
    const double rate = -(w_x * n_x + w_z * n_z);
    double C = C_mean, T = T_mean;
    if constexpr (Uneven) {
      C = C_ij[p];
      T = T_ij[p];
    }
    T = overlap > 0.0 ? T : 0.0;
    const double along = where_closed(force, K, C, overlap, rate) - T * rate;
    x[p] = overlap;
    F_x[p] = along * n_x - T * w_x;
    F_z[p] = along * n_z - T * w_z;
    if constexpr (Books)
      lost[p] = where_closed(force, 0.0, C, overlap, rate) * rate + T * (w_x * w_x + w_z * w_z - rate * rate);
  }
}

template <class Force, bool Uneven, bool Books>
void LatticeContacts<Force, Uneven, Books>::press(Wall& wall, const double* q, const double* u) {
  const double overlap = -wall.bond.gap(of(q, wall.bead));
  const Vec2<double> w = of(u, wall.bead), n = wall.bond.R;
  const double rate = -dot(w, n), T = overlap > 0.0 ? wall.T : 0.0;
  wall.F = (where_closed(force_, K_wall_, wall.C, overlap, rate) - T * rate) * n - T * w;
  x_[wall.contact] = overlap;
  if constexpr (Books)
    lost_[wall.contact] = where_closed(force_, 0.0, wall.C, overlap, rate) * rate + T * (dot(w, w) - rate * rate);
}

template <class Force, bool Uneven, bool Books>
void LatticeContacts<Force, Uneven, Books>::hand_out(double* a) const {
  const std::size_t components = 2 * lattice_.count();
  for (std::size_t k = 0; k < components; ++k) a[k] = 0.0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    if (!(x_[p] > 0.0)) continue;
    double *on_i = a + i_[p], *on_j = a + j_[p];
    on_i[0] += F_x_[p];
    on_i[1] += F_z_[p];
    on_j[0] -= F_x_[p];
    on_j[1] -= F_z_[p];
  }
  for (const Wall& wall : walls_) {
    a[2 * wall.bead] += wall.F.x;
    a[2 * wall.bead + 1] += wall.F.z;
  }
  if constexpr (Uneven)
    for (std::size_t k = 0; k < components; ++k) a[k] *= lattice_.beads.inverse_mass(k / 2);
}

template <class Force, bool Uneven, bool Books>
template <class AtBottom>
ContactChanges LatticeContacts<Force, Uneven, Books>::look(AtBottom&& at_bottom) {
  for (const Wall& wall : walls_) {
    const double now = x_[wall.contact], before = before_[wall.contact];
    if (wall.bottom && (now > 0.0) != (before > 0.0)) at_bottom(before, now);
  }
  const double* x = x_.data();
  double* before = before_.data();
  std::int64_t closed = 0, opened = 0;
  double deepest = deepest_;
#pragma GCC ivdep
  for (std::size_t c = 0, n = x_.size(); c < n; ++c) {
    closed |= x[c] > 0.0;
    opened += (before[c] > 0.0) & !(x[c] > 0.0);
    deepest = x[c] > deepest ? x[c] : deepest;
    before[c] = x[c];
  }
  deepest_ = deepest;
  return {static_cast<std::uint64_t>(opened), closed != 0};
}

template <class Force, bool Uneven, bool Books>
template <class With>
void LatticeContacts<Force, Uneven, Books>::each(const double* q, const double* u, With&& with) const {
  const auto& beads = lattice_.beads;
  const auto show = [&](const Bond<double>& bond, const Vec2<double>& apart, const Vec2<double>& w, double K,
                        double inertia, double eps) {
    const double overlap = -bond.gap(apart);
    with(overlap, -dot(w, bond.direction(apart).n), std::sqrt(dot(w, w)),
         overlap > 0.0 ? force_.twice_elastic_energy(K, overlap) : 0.0, inertia, eps);
  };
  for (std::size_t p = 0; p < pairs_; ++p) {
    const auto i = static_cast<std::size_t>(i_[p] / 2), j = static_cast<std::size_t>(j_[p] / 2);
    show({{R_x_[p], R_z_[p]}, length_[p], gap0_[p]}, of(q, i) - of(q, j), of(u, i) - of(u, j), K_,
         beads.inverse_mass(i) + beads.inverse_mass(j), beads.eps);
  }
  for (const Wall& wall : walls_)
    show(wall.bond, of(q, wall.bead), of(u, wall.bead), K_wall_, beads.inverse_mass(wall.bead), beads.eps_wall);
}

}  // namespace sigmasweep
