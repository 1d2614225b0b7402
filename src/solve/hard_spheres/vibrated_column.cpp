#include "solve/hard_spheres/vibrated_column.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "solve/hard_spheres/scales.hpp"
#include "solve/observer/samples.hpp"
#include "solve/observer/vibration_statistics.hpp"

namespace sigmasweep {
namespace {

// In periods:
constexpr double same_time = 1e-15;       // times closer than this are the same
constexpr double in_touch = 1e-12;        // a gap that closes within this is none where beads collapse
constexpr double again = 1e-9;            // a pair that collides again within this does so in next to no time
constexpr double shortest_flight = 1e-8;  // on the plate: it is as high as the roundings of the heights

/// A pair that collides again and again in next to no time, by now slower than this part of its fastest collision
/// there, will do so for ever.
constexpr double collapsed = 1e-15;

}  // namespace

VibratedHardSpheres::VibratedHardSpheres(const Column<double>& column, const Plate& plate, const Settings& settings,
                                         const RunLimits& limits)
    : plate_(plate),
      settings_(settings),
      stop_(limits, 20'000'000'000, std::numeric_limits<std::uint64_t>::max()),
      period_(plate.period()),
      e_(column.eps),
      e_wall_(column.eps_wall),
      equal_masses_(column.is_uniform()),
      contacts_(column.contacts()),
      heaviest_speed_(spread(column.mass)),
      due_(contacts_.size()),
      impacts_(contacts_.size()),
      load_(plate.load(0.0)),
      plate_speed_(plate.speed(0.0)) {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Contact& contact = contacts_[k];
    contact.gap = column.initial_gap(k);
    if (!equal_masses_) contact.mass = column.mass[k];
    if (k == 0) continue;
    contact.below = contact.mass / (contacts_[k - 1].mass + contact.mass);
    contact.above = contacts_[k - 1].mass / (contacts_[k - 1].mass + contact.mass);
  }
  start_energy_ = energy();
}

bool VibratedHardSpheres::gives_up() {
  const bool is_stuck = collisions_ - period_began_ >= settings_.period_limit;
  const Status stop = is_stuck ? Status::event_limit : stop_.why_stop(collisions_, 0, 1);
  if (stop == Status::ok) return false;
  status_ = stop;
  return true;
}

/// To the next time at which anything happens; all who meet then become touching.
void VibratedHardSpheres::advance(double time) {
  now_ = time;
  load_ = plate_.load(now_);
  plate_speed_ = plate_.speed(now_);
  for (std::size_t k = due_.first(); due_.time_of(k) - now_ <= same_time * period_; k = due_.first()) touch(k);
}

/// A full turn of the plate is taken off the clock.
void VibratedHardSpheres::begin_period() {
  now_ = 0.0;
  load_ = plate_.load(now_);
  plate_speed_ = plate_.speed(now_);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].since -= period_;
    contacts_[k].last -= period_;
    if (due_.time_of(k) < infinity) due_.set(k, due_.time_of(k) - period_);
  }
  in_ += resting_mass_ * (energy_with_plate(now_) - booked_);
  booked_ = energy_with_plate(now_);
  if (resting_ > 0) take_off_ = plate_.take_off(now_);
  all_in_ += std::exchange(in_, 0.0);
  all_dissipated_ += std::exchange(dissipated_, 0.0);
  period_began_ = collisions_;
}

/// In the room's frame, the plate in its middle position being of height 0.
double VibratedHardSpheres::energy() const {
  double sum = 0.0, v = plate_speed_, z = plate_.height(now_);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const State state = at(k, now_);
    v -= state.u;
    z -= state.x;
    sum += contacts_[k].mass * (0.5 * v * v + plate_.g * z);
  }
  return sum;
}

/// Of a unit of mass.
double VibratedHardSpheres::energy_with_plate(double t) const {
  return 0.5 * plate_.speed(t) * plate_.speed(t) + plate_.g * plate_.height(t);
}

void VibratedHardSpheres::update(std::size_t k) {
  const State state = at(k, now_);
  Contact& contact = contacts_[k];
  contact.gap = -state.x;
  contact.u = state.u;
  contact.since = now_;
}

void VibratedHardSpheres::touch(std::size_t k) {
  update(k);
  Contact& contact = contacts_[k];
  contact.gap = 0.0;
  contact.u = std::max(contact.u, 0.0);
  schedule(k);
}

/// The present state of contact k is new: when will it collide?
void VibratedHardSpheres::schedule(std::size_t k) {
  const Contact& contact = contacts_[k];
  const bool touches = contact.gap == 0.0 && contact.u > 0.0;
  if (touches)
    impacts_.set(k, -contact.u);  // LRV: the fastest is first
  else
    impacts_.remove(k);
  if (touches || !(contact.u > 0.0))
    due_.remove(k);
  else if (k != resting_)
    due_.set(k, std::max(contact.since + contact.gap / contact.u, now_));
  if (k == resting_) aimless_ = true;
}

/// Contact k closes faster by `change`.
void VibratedHardSpheres::change_rate(std::size_t k, double change) {
  update(k);
  Contact& contact = contacts_[k];
  const double u = contact.u + change;
  contact.u = std::fabs(u) <= cancelled<double> * std::fabs(change) ? 0.0 : u;
  schedule(k);
}

/// The touching contact that approaches fastest: a collision, or the last of infinitely many.
void VibratedHardSpheres::meet(std::size_t k) {
  if (settings_.rule == EdRule::lrv && (comes_to_rest(k) || collapses(k))) return;
  collide(k);
}

/// u -> -e u. The beads share the change (1 + e) u by their masses; at the plate the bead takes all of it.
void VibratedHardSpheres::collide(std::size_t k) {
  Contact& contact = contacts_[k];
  const double e = settings_.rule == EdRule::tc && is_elastic(k) ? 1.0 : k == 0 ? e_wall_ : e_;
  const double u = contact.u, change = (1.0 + e) * u, reduced_mass = contact.mass * contact.above;
  contact.fastest = is_again(k) ? std::max(contact.fastest, u) : u;
  contact.u = -e * u;
  contact.last = now_;
  schedule(k);
  if (k > 0) change_rate(k - 1, contact.below * change);
  if (k + 1 < contacts_.size()) change_rate(k + 1, contact.above * change);
  if (k == 0) in_ += plate_speed_ * reduced_mass * change;
  dissipated_ += 0.5 * reduced_mass * (1.0 - e) * (1.0 + e) * u * u;
  ++collisions_;
}

bool VibratedHardSpheres::is_again(std::size_t k) const { return now_ - contacts_[k].last <= again * period_; }

/// The TC model: one of the two beads has collided, with the other one or its other neighbour, less than tc ago.
bool VibratedHardSpheres::is_elastic(std::size_t k) const {
  double last = contacts_[k].last;
  if (k > 0) last = std::max(last, contacts_[k - 1].last);
  if (k + 1 < contacts_.size()) last = std::max(last, contacts_[k + 1].last);
  return now_ - last < settings_.tc;
}

/// Contact k is so slow that its bead, falling back to the plate, would be there within the shortest flight; so are all
/// contacts below it, and maybe some above: these beads rest on the plate.
bool VibratedHardSpheres::comes_to_rest(std::size_t k) {
  const double speed = 0.5 * load_ * shortest_flight * period_;
  if (!(contacts_[k].u <= speed)) return false;
  const double gap = 0.5 * speed * speed / load_;
  Cluster cluster{.wall = true};
  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    const State state = at(j, now_);
    if (!(std::fabs(state.u) <= speed && -state.x <= gap)) break;
    ++cluster.beads;
    cluster.top_change += state.u;
  }
  if (cluster.beads < k + 2) return false;
  join(0, cluster);
  return true;
}

/// As in a column that nothing drives: what happens in one moment knows nothing of gravity or of a moving plate.
bool VibratedHardSpheres::collapses(std::size_t k) {
  if (!is_again(k)) return false;
  const bool is_over = contacts_[k].u < collapsed * contacts_[k].fastest;
  if (!is_over && !(equal_masses_ && collisions_ >= next_try_)) return false;
  const std::size_t lowest = find_touching(k);
  next_try_ = collisions_ + 16 + touching_.size();
  const Cluster cluster = cluster_around(k - lowest, touching_, lowest == 0, masses_from(lowest));
  if (!is_over && !will_collapse(cluster, e_)) return false;
  join(lowest, cluster);
  return true;
}

/// The run of contacts around k that are closed, or would be in next to no time at the speed of k. Returns the lowest.
std::size_t VibratedHardSpheres::find_touching(std::size_t k) {
  // A contact that recedes faster than all others together can close it stays open.
  const double fastest = heaviest_speed_ * static_cast<double>(contacts_.size()) * contacts_[k].u;
  const double widest = in_touch * period_ * contacts_[k].u;
  const auto touches = [&](std::size_t j) {
    const State state = at(j, now_);
    return -state.x <= widest && std::fabs(state.u) <= fastest;
  };
  std::size_t lowest = k;
  while (lowest > 0 && touches(lowest - 1)) --lowest;
  touching_.clear();
  for (std::size_t j = lowest; j <= k || (j < contacts_.size() && touches(j)); ++j) touching_.push_back(at(j, now_).u);
  return lowest;
}

/// Masses of the beads from the one below the contact on (the plate's is not looked at); empty where all are equal.
std::vector<double> VibratedHardSpheres::masses_from(std::size_t contact) const {
  std::vector<double> mass;
  if (equal_masses_) return mass;
  mass.push_back(contact > 0 ? contacts_[contact - 1].mass : infinity);
  for (std::size_t k = contact; k < contacts_.size(); ++k) mass.push_back(contacts_[k].mass);
  return mass;
}

/// Infinitely many collisions, done at once: the beads of the cluster, part of a run of contacts from `lowest` on,
/// touch and have one velocity from now on.
void VibratedHardSpheres::join(std::size_t lowest, const Cluster& cluster) {
  status_ = Status::collapsed;
  const std::size_t first = lowest + cluster.first, end = first + cluster.beads - 1;
  const double common = cluster.wall ? 0.0 : cluster.bottom_change;  // relative to the lowest bead, or the plate
  if (!cluster.wall) dissipated_ += 0.5 * contacts_[first - 1].mass * common * common;
  double v = 0.0, fall = 0.0;
  for (std::size_t k = first; k < end; ++k) {
    update(k);
    Contact& contact = contacts_[k];
    v -= contact.u;
    fall += contact.gap;  // what little was left of it
    dissipated_ += contact.mass * plate_.g * fall;
    dissipated_ += 0.5 * contact.mass * (v - common) * (v - common);
    if (cluster.wall) in_ -= plate_speed_ * contact.mass * v;
    contact.gap = contact.u = 0.0;
    contact.last = now_;
    schedule(k);
  }
  if (first > 0) change_rate(first - 1, -cluster.bottom_change);
  if (end < contacts_.size()) {
    update(end);
    contacts_[end].gap += fall;
    change_rate(end, cluster.top_change);
  }
  ++collisions_;
}

/// Nothing collides now. Which beads rest on the plate, and when is the contact above due?
void VibratedHardSpheres::settle() {
  std::size_t beads = 0;
  if (rests(0) && plate_.holds(now_))
    while (beads < contacts_.size() && rests(beads)) ++beads;
  if (beads != resting_) let_rest(beads);
  if (!aimless_ || resting_ == contacts_.size()) return;
  const Contact& contact = contacts_[resting_];
  due_.set(resting_, now_ + plate_.landing({-contact.gap, contact.u}, now_));
  aimless_ = false;
}

/// Whether contact k is closed and does not move; the driven one now, the others all the time.
bool VibratedHardSpheres::rests(std::size_t k) const {
  const Contact& contact = contacts_[k];
  return contact.gap == 0.0 && contact.u == 0.0 && (k != resting_ || contact.since == now_);
}

void VibratedHardSpheres::let_rest(std::size_t beads) {
  in_ += resting_mass_ * (energy_with_plate(now_) - booked_);
  booked_ = energy_with_plate(now_);
  resting_mass_ = 0.0;
  for (std::size_t k = 0; k < beads; ++k) resting_mass_ += contacts_[k].mass;
  const std::size_t before = resting_;
  for (const std::size_t k : {before, beads})
    if (k < contacts_.size()) update(k);
  resting_ = beads;
  for (const std::size_t k : {before, beads})
    if (k < contacts_.size()) schedule(k);
  take_off_ = beads > 0 ? plate_.take_off(now_) : infinity;
}

namespace {

VibratedHardSpheres spheres_of(const Parameters& p, const Column<double>& column, ComputeBudget* budget) {
  const VibrationUnits units = vibration_units(p);
  return {column, Plate::of(p, units), {.rule = p.ed_rule, .tc = p.tc / units.time}, {.budget = budget}};
}

Column<double> column_of(const Parameters& p) {
  const double length = vibration_units(p).length;
  Column<double> column = si_column<double>(p);
  column.gap /= length;
  for (double& gap : column.gaps) gap /= length;
  return column;
}

}  // namespace

SimulationResult simulate_vibrated_hard_spheres(const Parameters& p, ComputeBudget* budget) {
  const Column<double> column = column_of(p);
  const VibrationUnits units = vibration_units(p);
  VibrationStatistics statistics(p, column, Plate::of(p, units), units, MotionBetween::flights);
  VibratedHardSpheres spheres = spheres_of(p, column, budget);
  spheres.run(statistics);
  SimulationResult c;
  c.status = spheres.status();
  if (!is_success(c.status)) return c;
  c.vibration = statistics.result();
  c.x_max = 0.0;
  c.contacts = spheres.collisions();
  c.end = End::periods;
  return c;
}

void observe_vibrated_hard_spheres(const Parameters& p, VibratedSamples& samples) {
  spheres_of(p, column_of(p), nullptr).run(samples);
}

}  // namespace sigmasweep
