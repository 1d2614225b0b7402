#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "solve/exact/linear/taylor_group.hpp"

namespace sigmasweep {

/// How far a Taylor step may reach: taylor_reach over the largest rate |s| among the modes e^(st) of its chains of
/// closed contacts.
template <class Real, bool HasUnequalMasses>
class StepLengths;

/// Beads of equal mass: the dashpots are proportional to the springs, so the modes obey
/// s^2 + lambda C s + lambda K = 0. The largest eigenvalue lambda of a chain of c contacts is
///     2 + 2 cos(pi/(c+1))       for a free chain,
///     2 + 2 cos(2 pi/(2c+1))    for one at the wall, if the wall has a pair's spring and dashpot;
/// a wall of twice these raises it to at most 3 + sqrt 2 (Gershgorin), or 2 for c = 1. Any other wall: the bounds of
/// StepLengths<Real, true>, below.
template <class Real>
class StepLengths<Real, false> {
 public:
  explicit StepLengths(const Column<Real>& column) : K_(column.K), C_(column.C) {
    const double pi = 3.14159265358979323846;
    const bool paper = column.K_wall == column.K && column.C_wall == column.C;
    const bool matched = column.K_wall == 2 * column.K && column.C_wall == 2 * column.C;
    const std::size_t used = std::min(longest_chain, std::size_t(column.N));
    for (std::size_t c = 1; c <= used; ++c) {
      const double n = double(c);
      free_[c] = reach(2.0 + 2.0 * std::cos(pi / (n + 1.0)));
      wall_[c] = reach(paper ? 2.0 + 2.0 * std::cos(2.0 * pi / (2.0 * n + 1.0)) : c == 1 ? 2.0 : 3.0 + std::sqrt(2.0));
    }
    // Past longest_chain the eigenvalue is within 1 % of its limit.
    free_[0] = reach(4.0);
    wall_[0] = reach(paper ? 4.0 : 3.0 + std::sqrt(2.0));
    unconnected_ = reach(1.0);
    if (!paper && !matched) take_wall(column);
  }

  /// The shortest of what the chains within the contacts lo..hi allow.
  Real longest(std::size_t lo, std::size_t hi, std::span<const std::uint8_t> closed) const {
    Real h = unconnected_;
    for (std::size_t k = lo; k <= hi; ++k) {
      const std::size_t first = k;
      while (k <= hi && closed[k]) ++k;
      if (k > first) h = std::min(h, first == 0 ? at_wall(k - first) : free(k - first));
    }
    return h;
  }

 private:
  void take_wall(const Column<Real>& column) {
    using std::sqrt;
    const auto within = [](const Real& AK, const Real& AC) {
      return Real(Real(taylor_reach) / std::max(Real(sqrt(AK)), AC));
    };
    wall_.fill(within(column.K_wall + 3 * column.K, column.C_wall + 3 * column.C));
    wall_[1] = within(column.K_wall, column.C_wall);
  }
  const Real& free(std::size_t chain) const { return free_[chain > longest_chain ? 0 : chain]; }
  const Real& at_wall(std::size_t chain) const { return wall_[chain > longest_chain ? 0 : chain]; }
  Real reach(double lambda) const {
    using std::sqrt;
    const Real damping = Real(lambda) * C_ / 2, stiffness = Real(lambda) * K_;
    const Real discriminant = damping * damping - stiffness;
    const Real rate = discriminant > 0 ? Real(damping + sqrt(discriminant)) : Real(sqrt(stiffness));
    return Real(taylor_reach) / rate;
  }

  static constexpr std::size_t longest_chain = 16;
  Real K_, C_, unconnected_{};
  std::array<Real, longest_chain + 1> free_{}, wall_{};
};

/// Beads with masses of their own: |s|^2 is at most the largest eigenvalue of A K, or |s| that of A C, with
/// A = tridiag(-1/m_(k-1), 1/m_(k-1) + 1/m_k, -1/m_k). Both are at most the largest sum of magnitudes in a row
/// (Gershgorin). Derivation: docs/physics/exact-linear.md.
template <class Real>
class StepLengths<Real, true> {
 public:
  explicit StepLengths(const Column<Real>& column) {
    const std::size_t N = column.contacts();
    for (std::size_t k = 0; k < N; ++k) {
      const Real below = k > 0 ? column.inverse_mass(k - 1) : Real(0), above = column.inverse_mass(k);
      const std::size_t last = k > 0 ? k - 1 : k, next = k + 1 < N ? k + 1 : k;
      spring_.push_back(
          {below * column.spring(last), column.inertia(k) * column.spring(k), above * column.spring(next)});
      dashpot_.push_back(
          {below * column.dashpot(last), column.inertia(k) * column.dashpot(k), above * column.dashpot(next)});
    }
  }

  Real longest(std::size_t lo, std::size_t hi, std::span<const std::uint8_t> closed) const {
    using std::sqrt;
    Real AK = 0, AC = 0;
    for (std::size_t k = lo; k <= hi; ++k) {
      if (!closed[k]) continue;
      const bool below = k > lo && closed[k - 1], above = k < hi && closed[k + 1];
      AK = std::max(AK, spring_[k].sum(below, above));
      AC = std::max(AC, dashpot_[k].sum(below, above));
    }
    return Real(taylor_reach) / std::max(Real(sqrt(AK)), AC);
  }

 private:
  struct Row {
    Real below, diagonal, above;
    Real sum(bool with_below, bool with_above) const {
      Real all = diagonal;
      if (with_below) all += below;
      if (with_above) all += above;
      return all;
    }
  };
  std::vector<Row> spring_, dashpot_;  ///< of A K and A C
};

}  // namespace sigmasweep
