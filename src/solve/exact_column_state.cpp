#include <algorithm>

#include "exact_column.hpp"

namespace sigmasweep {

/// Overlaps and rates of all contacts at a time between the last event and the next; changes nothing.
template <class Real, int Disturbances, bool Uneven, int Order>
void ExactColumn<Real, Disturbances, Uneven, Order>::state_at(const Real& t, std::span<Real> x, std::span<Real> u) const {
  for (std::size_t k = 0; k < N_; ++k) {
    if (group_of_[k] == none) {
      x[k] = x_[k] + u_[k] * (t - at_[k]);
      u[k] = u_[k];
      continue;
    }
    const Group& group = *groups_[std::size_t(group_of_[k])];
    const Real elapsed = std::min(std::max(Real(t - group.start), Real(0)), group.length);
    const std::size_t n = group.hi - group.lo + 1, closed = group.contact;
    if (!group.binary) {
      group.taylor.evaluate(0, elapsed / group.longest, x.subspan(group.lo, n), u.subspan(group.lo, n));
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

template void ExactColumn<double, 0, false>::state_at(const double&, std::span<double>, std::span<double>) const;
template void ExactColumn<double, 0, true>::state_at(const double&, std::span<double>, std::span<double>) const;

}  // namespace sigmasweep
