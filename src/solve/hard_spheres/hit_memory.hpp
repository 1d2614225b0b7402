#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace sigmasweep {

/// A collision at `contact` of a run of touching contacts, lowest to highest, in which all others are at rest.
struct Hit {
  std::size_t lowest, contact, highest;
  auto operator<=>(const Hit&) const = default;
};

/// All that a hit leads to in no time. Speeds are in units of the hit's.
template <class Real>
struct Aftermath {
  Real speed;                 ///< of the hit
  std::vector<Real> u{};      ///< closing speeds of the run's contacts when none of them approaches any more
  Real below = 0, above = 0;  ///< change of the closing speeds of the contacts next to the run
};

/// Remembers the aftermaths of hits. Collisions of touching beads know no unit of speed, so a cluster at rest that is
/// hit in the same place again does what it did before, if slower or faster. A bead that bounces on a cluster has it
/// collapse at each bounce, with ten thousand collisions each time; a bead above has it bounce so each time; and so on.
template <class Real>
class HitMemory {
 public:
  /// The aftermath of an equal hit. That of a faster one is known better: its last collisions are still slower than
  /// those of a collapse that is called over.
  const Aftermath<Real>* find(const Hit& hit, const Real& speed) const {
    const auto known = known_.find(hit);
    return known == known_.end() || speed > known->second.speed ? nullptr : &known->second;
  }

  bool is_watching() const { return watched_.has_value(); }
  const Hit& watched() const { return *watched_; }
  void watch(const Hit& hit, const Real& speed) {
    watched_ = hit;
    seen_ = {.speed = speed};
  }
  /// The contact below or above the run closes faster.
  void note_change(std::size_t contact, const Real& change) {
    if (contact < watched_->lowest) seen_.below += change;
    if (contact > watched_->highest) seen_.above += change;
  }
  /// Others came to touch meanwhile.
  void forget_watched() { watched_.reset(); }
  /// Nobody approaches any more; u: closing speeds of the run.
  void keep_watched(std::vector<Real> u) {
    seen_.below /= seen_.speed;
    seen_.above /= seen_.speed;
    for (Real& speed : u) speed /= seen_.speed;
    seen_.u = std::move(u);
    if (known_.size() >= most) known_.clear();
    known_.insert_or_assign(*watched_, std::move(seen_));
    watched_.reset();
  }

 private:
  static constexpr std::size_t most = 64;  ///< hits remembered
  std::map<Hit, Aftermath<Real>> known_;
  std::optional<Hit> watched_;
  Aftermath<Real> seen_{};
};

}  // namespace sigmasweep
