#include <algorithm>

#include "solve/exact/linear/column.hpp"

namespace sigmasweep {

/// Overlaps and rates of all contacts at a time between the last event and the next; changes nothing.
template <class Real, int Disturbances, bool Uneven, int Order, class Ground>
void ExactColumn<Real, Disturbances, Uneven, Order, Ground>::state_at(const Real& t, std::span<Real> x,
                                                                      std::span<Real> u) const {
  for (std::size_t k = 0; k < N_; ++k) {
    if (group_of_[k] == Events::none) {
      const State now = this->free_state(k, t);
      x[k] = now.x;
      u[k] = now.u;
      continue;
    }
    const Group& group = Events::group(group_of_[k]);
    const Real elapsed = std::min(std::max(Real(t - group.start), Real(0)), group.length);
    const std::size_t n = group.hi - group.lo + 1, closed = group.contact;
    if constexpr (Ground::moves)
      if (group.resting) {
        on_ground_.resting->evaluate(elapsed, x, u);
        k = group.hi;
        continue;
      }
    if (!group.binary) {
      group.taylor.evaluate(0, elapsed / group.taylor.step(), x.subspan(group.lo, n), u.subspan(group.lo, n));
      k = group.hi;
      continue;
    }
    const State entry = state(closed), now = laws_.binary(closed).after(elapsed)(entry);
    if (k == closed) {
      x[k] = now.x;
      u[k] = now.u;
    } else {
      const State push = laws_.binary(closed).push(entry, now, elapsed);
      const Real between = k < closed ? laws_.below(closed) : laws_.above(closed);
      x[k] = x_[k] + u_[k] * elapsed + between * push.x;
      u[k] = u_[k] + between * push.u;
    }
  }
}

#define SIGMASWEEP_INSTANTIATE(...)                                                                                \
  template void ExactColumn<double, 0, __VA_ARGS__>::state_at(const double&, std::span<double>, std::span<double>) \
      const;
SIGMASWEEP_INSTANTIATE(false)
SIGMASWEEP_INSTANTIATE(true)
SIGMASWEEP_INSTANTIATE(false, TaylorOrder<double>::value, Plate)
SIGMASWEEP_INSTANTIATE(true, TaylorOrder<double>::value, Plate)
#undef SIGMASWEEP_INSTANTIATE

}  // namespace sigmasweep
