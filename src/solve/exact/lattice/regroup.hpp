#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solve/exact/lattice/schedule.hpp"
#include "solve/exact/lattice/state.hpp"

namespace sigmasweep {

/// Takes beads out of their clusters at an event and puts those that touch into new clusters, whose first steps it
/// makes; beads in no contact fly from there on.
///
/// Small groups of touching beads are one cluster, and moved exactly. In a large group an event restarts only the beads
/// within `reach` contacts of it, as a cluster of their own, whose guests are the beads around; all others keep the
/// motions that are known of them. So the work of an event does not grow with the group. Steps of such clusters all end
/// at the same times (sync times), so that no cluster waits for the motions of its guests. Why that is accurate:
/// docs/physics/lattices.md.
template <class Real, class Ground>
class Regrouping {
 public:
  using State = LatticeState<Real, Ground>;
  /// A bead that restarts at an event.
  struct Placed {
    std::uint32_t bead;
    Vec2<Real> q, v;
    Real span;  ///< expected of its next step
  };

  /// `accuracy`: of clusters' steps. `longest`: time between sync times.
  Regrouping(State& state, EventSchedule<Real, Ground>& schedule, double accuracy, const Real& longest)
      : state_(state), schedule_(schedule), accuracy_(accuracy), longest_(longest), slot_(state.beads.size()) {}

  /// The beads that cluster `id` still has are placed at t, its end or a time to which it is cut.
  void gather_cluster(std::size_t id, const Real& t, std::vector<Placed>& placed);
  /// The beads of `layer` and those within reach are placed at t.
  void gather_near(std::vector<std::uint32_t> layer, const Real& t, std::vector<Placed>& placed);
  /// Placed beads that touch one another become clusters, the others fly; events are predicted for all of them.
  void restart(std::vector<Placed>& placed, const Real& t);

  const Real& x_max() const { return x_max_; }  ///< largest overlap in steps that are over
  /// Beads and contacts moved since the last call.
  std::uint64_t take_work() { return std::exchange(work_, 0); }
  bool step_underflow() const { return step_underflow_; }  ///< no step length was short enough
  const PlateWork& plate_work() const { return plate_work_; }

 private:
  using Cluster = LatticeCluster<Real, Ground>;
  /// Beads of a cluster that is moved as a whole.
  static constexpr std::size_t max_whole = Ground::moves ? SIZE_MAX : 60;

  void note_overlaps(std::size_t i, const Real& t);
  Real next_sync_time(const Real& t) const;
  void restart_group(std::span<const std::uint32_t> group, const Real& span, const Real& t);
  void renew_list(std::size_t i, const Real& t);
  std::size_t new_cluster(std::size_t count);

  State& state_;
  EventSchedule<Real, Ground>& schedule_;
  double accuracy_;
  Real longest_;
  std::vector<std::size_t> free_clusters_;
  std::vector<std::unique_ptr<Cluster>> large_;  ///< not in use
  std::vector<std::uint32_t> slot_;              ///< scratch, for each bead
  Real x_max_{};
  std::uint64_t work_ = 0;
  PlateWork plate_work_;
  bool step_underflow_ = false;
};

}  // namespace sigmasweep
