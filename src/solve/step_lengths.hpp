#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sigmasweep/solve/column.hpp"
#include "taylor_group.hpp"

namespace sigmasweep {

/// How far a Taylor step may reach: taylor_reach over the largest rate |s| among the modes
/// s^2 + lambda C s + lambda K = 0 of a chain of c closed contacts, whose largest eigenvalue lambda is
///     2 + 2 cos(pi/(c+1))       for a free chain,
///     2 + 2 cos(2 pi/(2c+1))    for one at the wall, if the wall has a pair's spring and dashpot;
/// a wall of twice these raises it to at most 3 + sqrt 2 (Gershgorin), or 2 for c = 1.
template <class Real>
class StepLengths {
 public:
  explicit StepLengths(const Column<Real>& column) : K_(column.K), C_(column.C) {
    const double pi = 3.14159265358979323846;
    const bool paper = column.K_wall == column.K;
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
  }

  const Real& free(std::size_t chain) const { return free_[chain > longest_chain ? 0 : chain]; }
  const Real& at_wall(std::size_t chain) const { return wall_[chain > longest_chain ? 0 : chain]; }
  const Real& unconnected() const { return unconnected_; }

 private:
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

}  // namespace sigmasweep
