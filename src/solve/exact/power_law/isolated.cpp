#include "solve/exact/power_law/isolated.hpp"

#include <algorithm>

namespace sigmasweep {
namespace {

/// Closing overlaps that a contact is at least deep: what is left out below the closing overlap is nothing beside it.
constexpr double least_depth = 1e6;
constexpr int max_steps = 1000;

}  // namespace

IsolatedContacts::IsolatedContacts(const Column<double>& column, double accuracy, double restitution_off)
    : column_(column),
      accuracy_(accuracy),
      restitution_off_(restitution_off),
      collision_(column.contacts()),
      busy_(column.contacts(), 0),
      closed_(column.contacts(), 0),
      x_(column.contacts()),
      u_(column.contacts()),
      alone_(column, accuracy) {
  if (accuracy <= 2.0 * CollisionTable::accuracy) table_ = nullptr;
}

PairLaw IsolatedContacts::law(std::size_t k) const {
  const double inertia = column_.inertia(k);
  return {column_.exponents, inertia * column_.spring(k), inertia * column_.dashpot(k)};
}

double IsolatedContacts::least_duration(std::size_t k, double u) const {
  return 2.0 * theory::largest_overlap(law(k), u) / u;
}

double IsolatedContacts::share(std::size_t k, std::size_t beside) const {
  return column_.inverse_mass(std::min(k, beside)) / column_.inertia(k);
}

std::optional<ContactState<double>> IsolatedContacts::virtual_state(std::size_t k,
                                                                    const ContactState<double>& closing) {
  if (!table_) table_ = CollisionTable::of(column_.exponents);
  if (!*table_ || !(closing.u > 0.0)) return std::nullopt;
  const auto c = (*table_)->collide(law(k), closing.u);
  if (!c || !(c->x_max > least_depth * PowerLawGroup<double>::closing_overlap(accuracy_))) return std::nullopt;
  x_max_ = c->x_max;
  const double u = c->eps * (1.0 - restitution_off_) * closing.u;
  return ContactState<double>{u * (c->duration - closing.x / closing.u), -u};
}

void IsolatedContacts::begin(std::size_t k, const ContactState<double>& closing, double t) {
  collision_[k] = {closing, t, x_max_};
  busy_[k] = 1;
  ++count_;
}

double IsolatedContacts::end(std::size_t k) {
  busy_[k] = 0;
  --count_;
  return collision_[k].x_max;
}

ContactState<double> IsolatedContacts::true_state(std::size_t k, double t) {
  double left = t - collision_[k].begun;
  if (!(left > 0.0)) return collision_[k].closing;
  x_[k] = collision_[k].closing.x;
  u_[k] = collision_[k].closing.u;
  closed_[k] = 1;
  alone_.start(k, k, closed_, x_, u_);
  for (int steps = 0; alone_.step(0.0) && alone_.length() < left && !alone_.event() && steps < max_steps; ++steps) {
    left -= alone_.length();
    alone_.finish(x_, u_);
  }
  alone_.within(left, x_, u_);
  return {x_[k], u_[k]};
}

}  // namespace sigmasweep
