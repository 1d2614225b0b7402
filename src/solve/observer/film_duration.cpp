#include "solve/observer/film_duration.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/column.hpp"

namespace sigmasweep {
namespace {

/// Times of the first and the last contact with the wall, from the start of the fall, s.
struct Contacts {
  double first, last;
};

/// Contacts of a collision. Not inlined, so that the time of the first contact is rounded before t_k is added.
[[gnu::noinline]] Contacts contacts_with_wall(double first_contact, const SimulationResult& collision) {
  return {first_contact, first_contact + collision.t_k};
}

double until_after(const Parameters& p, double last_contact) {
  if (last_contact > 0.0 || std::isnan(last_contact)) return 1.5 * last_contact;
  return 1.5 * static_cast<double>(p.N) * p.tc;
}

}  // namespace

double film_of_column(const Parameters& p, const SimulationResult& collision) {
  const double first_contact = reduced_column<double>(p).initial_gap(0) * p.tc;
  return until_after(p, contacts_with_wall(first_contact, collision).last);
}

double film_of_lattice(const Parameters& p, const SimulationResult& collision) {
  const double sigma_tc = p.sigma * p.tc;  // s0/v0
  const auto [first_contact, last_contact] = contacts_with_wall(sigma_tc, collision);
  if (std::isnan(last_contact)) return until_after(p, last_contact);
  return std::min(1.5 * last_contact,
                  first_contact + 3.0 * static_cast<double>(p.rows) * (p.tc + (p.s0 + p.width) / p.v0));
}

double film_on_plate(const Parameters& p, const SimulationResult& result) {
  constexpr double shown_periods = 10.0;
  return std::isnan(result.vibration.h_cm) ? result.vibration.h_cm : shown_periods / p.frequency;
}

}  // namespace sigmasweep
