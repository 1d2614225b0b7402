#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace sigmasweep {

/// Kinds of events of a lattice: a gap closes or opens; a cluster's step is over; a bead has gone so far that its list
/// of neighbours must be made anew.
enum class LatticeEventKind : std::uint8_t { gap, step, list };

/// A predicted event. It is void once a bead's (or a cluster's) version has grown since the prediction.
template <class Real>
struct LatticeEvent {
  Real time;
  LatticeEventKind kind;
  std::uint32_t bead, other;  ///< of a step: other is the cluster
  std::int32_t image;
  std::uint32_t version, other_version;
  bool operator>(const LatticeEvent& e) const { return time > e.time; }
};

/// Predicted events, the earliest on top.
template <class Real>
class EventQueue : public std::priority_queue<LatticeEvent<Real>, std::vector<LatticeEvent<Real>>, std::greater<>> {
 public:
  template <class Predicate>
  void keep_if(Predicate&& keep) {
    std::erase_if(this->c, [&](const LatticeEvent<Real>& e) { return !keep(e); });
    std::make_heap(this->c.begin(), this->c.end(), this->comp);
  }
};

}  // namespace sigmasweep
