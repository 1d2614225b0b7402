#include "solve/hard_spheres/late_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sigmasweep {
namespace {

constexpr long double vanishing = 1e-600L;  // of the fastest approach at the beginning
constexpr long double same_time = 1.0L + 1e-12L;
constexpr long double cancelled = 1e-17L;  // of the change of a speed: rounding
constexpr std::size_t most_collisions = 10'000, most_work = 300'000;

long double wait_of(const Approach& contact) {
  return contact.u > 0.0L ? contact.gap / contact.u : std::numeric_limits<long double>::infinity();
}

/// The fastest of the contacts that collide next.
std::size_t next_of(const std::vector<Approach>& contacts) {
  long double shortest = std::numeric_limits<long double>::infinity();
  for (const Approach& contact : contacts) shortest = std::min(shortest, wait_of(contact));
  std::size_t next = contacts.size();
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k].u > 0.0L && wait_of(contacts[k]) <= same_time * shortest &&
        (next == contacts.size() || contacts[k].u > contacts[next].u))
      next = k;
  return next;
}

void change(Approach& contact, long double by) {
  const long double u = contact.u + by;
  contact.u = std::fabs(u) <= cancelled * std::fabs(by) ? 0.0L : u;
}

}  // namespace

LateCollisions late_collisions(std::vector<Approach> contacts, long double e, long double e_wall) {
  long double fastest = 0.0L, now = 0.0L;
  for (const Approach& contact : contacts) fastest = std::max(fastest, contact.u);
  const std::size_t most = std::min(most_collisions, most_work / contacts.size());
  for (LateCollisions late; late.contacts < most; ++late.contacts) {
    const std::size_t k = next_of(contacts);
    if (k == contacts.size()) {
      late.end = End::separated;
      return late;
    }
    if (contacts[k].u < vanishing * fastest) return {.status = Status::collapsed};
    const long double wait = wait_of(contacts[k]), closing = contacts[k].u;
    const long double restitution = k > 0 ? e : e_wall, by = (1.0L + restitution) * closing;
    now += wait;
    for (Approach& contact : contacts) contact.gap = std::max(contact.gap - contact.u * wait, 0.0L);
    contacts[k].gap = 0.0L;
    contacts[k].u = -restitution * closing;
    if (k > 0) change(contacts[k - 1], contacts[k].below * by);
    if (k + 1 < contacts.size()) change(contacts[k + 1], contacts[k].above * by);
    if (k == 0) late.last_wall = now;
  }
  return {};
}

}  // namespace sigmasweep
