#include <algorithm>
#include <cmath>

#include "solve/exact/power_law/group.hpp"

/// What a vibrated plate adds to contacts under laws that are not linear.
namespace sigmasweep {

/// The plate's load on contact 0, the power of the plate and that lost in dashpots.
template <class Real, class Ground>
void PowerLawGroup<Real, Ground>::drive(State& dy, const Real* x, const Real* u,
                                        const Real& elapsed) requires(Ground::moves) {
  Real& power_in = dy[2 * n_];
  Real& power_lost = dy[2 * n_ + 1];
  power_in = power_lost = Real(0);
  if (lo_ == 0) {
    dy[n_] += ground_.load(begin_ + elapsed);
    power_in = F_[1] * ground_.speed(begin_ + elapsed);
  }
  const PowerLaw law(column_.exponents);
  for (std::size_t i = 0; i < n_; ++i)
    if (closed_[i]) power_lost += law.dashpot_force(C_[i], std::max(x[i], Real(0)), u[i]) * u[i];
}

template void PowerLawGroup<double, Plate>::drive(State&, const double*, const double*, const double&);

}  // namespace sigmasweep
