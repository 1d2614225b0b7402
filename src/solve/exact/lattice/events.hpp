#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "assembly/ground.hpp"
#include "assembly/lattice.hpp"
#include "assembly/lattice_neighbours.hpp"
#include "solve/exact/lattice/cluster.hpp"
#include "solve/outcome.hpp"
#include "solve/stop_logic.hpp"

namespace sigmasweep {

/// A lattice's motion from event to event. A bead in no contact flies in closed form; beads that touch are moved step
/// by step in clusters, each with a clock of its own. Events, in the order of time: the gap of a pair (or of a bead and
/// a wall) closes or opens, as predicted from the motions of both as far as they are known; a cluster's step is over; a
/// bead has gone so far that its list of neighbours must be made anew. When a bead's motion changes what was predicted
/// of it is void (its version grows), and predicted anew.
///
/// What touches in small groups is one cluster, and moved exactly. Of a large group an event concerns only those near
/// it at first: news travels from bead to bead, and what it does n beads away begins with the 2n-th power of the time.
/// So the beads within `reach` contacts of the event become a cluster of their own, whose guests are the beads around
/// it; all others keep the motions that are known of them. Their steps are short enough to let neither the news past
/// the reach nor the interpolation of motions matter at the accuracy asked for. They all end at the same times, beats,
/// so that nobody waits for what is known of a guest. So the work of an event does not grow with the cluster.
///
/// Ground: a fixed bottom, or a container that vibrates under gravity, seen from it.
template <class Real, class Ground = FixedWall>
class LatticeEvents {
 public:
  LatticeEvents(const Lattice<Real>& lattice, double accuracy, const RunLimits& limits, const Ground& ground = {});

  /// To the end of the collision, or of the watcher's interest (lattice_samples.hpp).
  template <class Watcher>
  LatticeOutcome<Real> run(Watcher& watcher);
  /// On a plate, instead of run(): period by period, until the watcher (LatticeStatistics) has seen enough.
  template <class Watcher>
  LatticeOutcome<Real> follow(Watcher& watcher) requires(Ground::moves);

 private:
  using Cluster = LatticeCluster<Real, Ground>;
  /// Beads of a cluster that is moved as a whole.
  static constexpr std::size_t max_whole = Ground::moves ? SIZE_MAX : 60;
  static constexpr Real never = std::numeric_limits<Real>::infinity();

  struct Bead {
    Vec2<Real> q, v;  ///< in no contact: at time `since`
    Real since{};
    std::int32_t cluster = -1;
    std::uint32_t place = 0;  ///< in its cluster
    std::uint32_t version = 0;
  };
  enum class Kind : std::uint8_t { gap, step, list };
  struct Event {
    Real time;
    Kind kind;
    std::uint32_t bead, other;  ///< of a step: the cluster
    std::int32_t image;
    std::uint32_t version, other_version;
    bool operator>(const Event& e) const { return time > e.time; }
  };
  class Queue : public std::priority_queue<Event, std::vector<Event>, std::greater<>> {
   public:
    template <class Predicate>
    void keep_if(Predicate&& keep) {
      std::erase_if(this->c, [&](const Event& e) { return !keep(e); });
      std::make_heap(this->c.begin(), this->c.end(), this->comp);
    }
  };
  struct Held {
    std::unique_ptr<Cluster> cluster;
    std::uint32_t version = 0;
    std::uint64_t counted = 0;           ///< of its work, before it was taken into use
    bool in_use = false, whole = false;  ///< whole: has no guests and is small
  };
  struct Placed {
    std::uint32_t bead;
    Vec2<Real> q, v;
    Real span;  ///< expected of its next step
  };

  // What is known of the motions.
  BeadState<Real> at(std::size_t i, const Real& t) const;
  Real until(std::size_t i) const;
  Motion<Real> gap(std::size_t i, const Neighbour<Real>& other, const Real& t) const;
  bool touches(std::size_t i, const Neighbour<Real>& other) const;

  // What is predicted.
  bool is_valid(const Event& event) const;
  Real next_event();
  void enqueue(const Real& t, Kind kind, std::uint32_t bead, const Neighbour<Real>& other);
  void predict_events(std::size_t i, const Real& t);
  void predict_events(std::size_t i, const Neighbour<Real>& other, const Real& t);
  Real meeting_in_flight(std::size_t i, const Neighbour<Real>& other, const Real& t) const;
  bool is_far(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& end) const;
  Real meeting_of_motions(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& until) const;
  Real opening(std::size_t i, const Neighbour<Real>& other, const Real& t, const Real& until) const;
  Real leaves(std::size_t i, const Real& t) const;

  // What happens.
  void handle(const Event& event);
  void change_gap(const Event& event);
  bool locate(Real& t, std::size_t i, const Neighbour<Real>& other, std::span<const std::size_t> whole);
  void close_contact(std::size_t i, const Neighbour<Real>& other, const Real& t);
  void count_contact_time(const Real& t);
  void note_wait(const Real& t);
  void open_contact(std::size_t i, const Neighbour<Real>& other, const Real& t);
  void note_overlaps(std::size_t i, const Real& t);
  void gather_near(std::vector<std::uint32_t> layer, const Real& t, std::vector<Placed>& placed);
  void gather_cluster(std::size_t id, const Real& t, std::vector<Placed>& placed);
  void restart(std::vector<Placed>& placed, const Real& t);
  Real next_sync_time(const Real& t) const;
  void restart_group(std::span<const std::uint32_t> group, const Real& span, const Real& t);
  void renew_list(std::size_t i, const Real& t);
  std::size_t new_cluster(std::size_t count);
  void begin_anew(const Real& t);
  Real approach();
  Real held();
  Real later_change(const Real& loss) const;
  Real kinetic(const Real& t) const;
  Real energy_at_start() const;
  void note_ending_uncertainty(LatticeOutcome<Real>& outcome);
  double energy(const Real& t) const requires(Ground::moves);
  void handle_next();
  Status why_stop();
  void show_at(const Real& t, std::span<Vec2<double>> q, std::span<Vec2<double>> v) const;
  template <class Watcher>
  void show(Watcher& watcher, const Real& t);

  const Lattice<Real>& lattice_;
  double accuracy_;
  StopLogic stop_;
  [[no_unique_address]] Ground ground_;
  LatticeNeighbours<Real> neighbours_;
  Real closing_overlap_, slowest_;
  Real longest_;  ///< between beats, at which steps of clusters that are not whole end
  std::vector<Bead> beads_;
  std::vector<std::vector<Neighbour<Real>>> touching_;
  std::vector<Held> clusters_;
  std::vector<std::size_t> free_clusters_;
  std::vector<std::unique_ptr<Cluster>> large_;  ///< not in use
  std::vector<std::uint32_t> mark_, slot_;       ///< scratch, for each bead
  std::uint32_t marks_ = 0;
  Queue queue_;
  Real now_{}, epoch_{};  ///< the clock began at epoch_
  Real last_touch_{}, last_change_{}, wall_closed_ = -Real(1), wall_opened_{}, x_max_{};
  Real contact_time_{}, counted_to_{};
  Waits<Real> waits_;
  std::uint64_t closed_ = 0, contacts_ = 0, work_ = 0, all_work_ = 0;
  PlateWork work_done_;
  bool step_underflow_ = false;  ///< no step length was short enough
};

}  // namespace sigmasweep
