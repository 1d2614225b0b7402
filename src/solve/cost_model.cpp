#include "solve/cost_model.hpp"

#include <algorithm>

namespace sigmasweep::cost {
namespace {

constexpr double unequal = 1.5;  // times the time of equal beads

double event_time(double N, double sigma, const EventCosts& costs) {
  const double wave = N * (costs.dense_bead + costs.dense_pair * N) / (1.0 + sigma);
  const double shared = N / (N + sigma);  // share of the contacts that overlap others: N of them in a time sigma
  return wave + later_contacts(N, sigma) * (costs.contact + costs.shared_contact * N * shared);
}

}  // namespace

double bounded_sigma(const Parameters& p) { return p.sigma < 1e12 ? p.sigma : 1e12; }

double later_contacts(double N, double sigma) { return N * N * sigma * sigma / (0.3 + sigma * sigma); }

double of_collision(const Parameters& p, const EventCosts& costs) {
  const double harder = p.width > 0.0 ? unequal : 1.0;
  return tuple + harder * event_time(static_cast<double>(p.N), bounded_sigma(p), costs);
}

double contacts_on_plate(const Parameters& p) {
  const double N = static_cast<double>(p.N);
  return 1.6 * static_cast<double>(p.periods) * N * N / std::max(1.0, p.alpha);
}

double of_periods(const Parameters& p, double contact) { return tuple + contact * contacts_on_plate(p); }

double of_lattice_events(const Parameters& p) {
  constexpr double bead_row = 80e-6;  // s; each bead and row, as contacts are so long or so many; in two runs
  return static_cast<double>(p.N) * (bead_row * static_cast<double>(p.rows));
}

}  // namespace sigmasweep::cost
