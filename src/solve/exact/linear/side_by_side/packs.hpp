#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "solve/exact/linear/side_by_side/lane.hpp"

namespace sigmasweep::side_by_side {

/// A tuple on its way through the lanes.
struct Traveller {
  std::size_t place;  ///< of the tuple
  Lane lane;
  LaneState state;  ///< while it waits; else the lanes have it
};

/// W lanes and the queue before them. InLanes: Columns or Jumps.
template <int W, template <int> class InLanes>
class LanePack {
 public:
  explicit LanePack(int N) : block_(std::make_unique<InLanes<W>>()) { block_->N = N; }

  InLanes<W>& block() { return *block_; }
  Traveller* in_lane(int l) { return inside_[l].get(); }
  int occupied() const { return occupied_; }
  int present() const { return occupied_ + static_cast<int>(waiting_.size()); }

  void add(std::unique_ptr<Traveller> traveller) { waiting_.push_back(std::move(traveller)); }

  /// Fills lanes from the queue, and gives each column its random bits.
  void prepare() {
    for (int l = 0; l < W; ++l) {
      if (!inside_[l] && !waiting_.empty()) {
        inside_[l] = std::move(waiting_.back());
        waiting_.pop_back();
        ++occupied_;
        put(l);
      }
      if (inside_[l]) block_->noise[l] = inside_[l]->lane.noise();
    }
  }

  /// Whether the column in lane l is to be looked at.
  bool wants_look(int l) {
    if (!inside_[l]->lane.is_due(block_->contacts[l])) return false;
    double approach = 0.0;
    for (int k = 0; k < block_->N; ++k) approach = std::max(approach, block_->u[k][l]);
    return inside_[l]->lane.wants_look(block_->contacts[l], approach);
  }

  /// Whether the column in lane l, which goes by steps, may go by jumps.
  bool may_jump(int l) const {
    const std::uint64_t closed = block_->closed_bits[l];
    return !(closed & closed >> 1) &&
           inside_[l]->lane.isolated().may_jump(&block_->x[0][l], &block_->u[0][l], W, block_->N, closed);
  }

  /// The state of the column in lane l.
  LaneState state(int l) const {
    const InLanes<W>& b = *block_;
    LaneState s;
    s.N = b.N;
    for (int k = 0; k < b.N; ++k) {
      s.x[k] = b.x[k][l];
      s.u[k] = b.u[k][l];
      s.dx[k] = b.dx[k][l];
      s.du[k] = b.du[k][l];
    }
    s.clock = b.clock[l];
    s.wall_opened = b.wall_opened[l];
    s.x_max = b.x_max[l];
    s.contacts = b.contacts[l];
    s.separated = b.separated[l] != 0;
    take_own(s, b, l);
    return s;
  }

  std::unique_ptr<Traveller> leave(int l) {
    block_->active[l] = 0;
    --occupied_;
    return std::move(inside_[l]);
  }

 private:
  void put(int l) {
    InLanes<W>& b = *block_;
    const LaneState& s = inside_[l]->state;
    for (int k = 0; k < b.N; ++k) {
      b.x[k][l] = s.x[k];
      b.u[k][l] = s.u[k];
      b.dx[k][l] = s.dx[k];
      b.du[k][l] = s.du[k];
    }
    b.clock[l] = s.clock;
    b.wall_opened[l] = s.wall_opened;
    b.x_max[l] = s.x_max;
    b.contacts[l] = s.contacts;
    b.separated[l] = 0;
    b.active[l] = -1;
    put_own(inside_[l]->lane, s, b, l);
  }

  static void take_own(LaneState& s, const Columns<W>& b, int l) {
    for (int k = 0; k < b.N; ++k) s.closed[k] = b.closed[k][l] != 0;
  }
  static void take_own(LaneState& s, const Jumps<W>& b, int l) {
    for (int k = 0; k < b.N; ++k) s.depth[k] = b.depth[k][l];
    s.wall_opens = b.wall_opens[l];
  }
  static void put_own(const Lane& lane, const LaneState& s, Columns<W>& b, int l) {
    b.closed_bits[l] = 0;
    for (int k = 0; k < b.N; ++k) {
      b.closed[k][l] = s.closed[k] ? -1 : 0;
      b.closed_bits[l] |= std::uint64_t(s.closed[k]) << k;
    }
    b.spring[l] = lane.law().spring;
    b.dashpot[l] = lane.law().dashpot;
    b.wall_spring[l] = lane.law().wall_spring;
    b.wall_dashpot[l] = lane.law().wall_dashpot;
  }
  static void put_own(const Lane& lane, const LaneState& s, Jumps<W>& b, int l) {
    for (int k = 0; k < b.N; ++k) b.depth[k][l] = s.depth[k];
    b.wall_opens[l] = s.wall_opens;
    for (int wall = 0; wall < 2; ++wall) {
      const ContactTimes& times = lane.isolated().times(wall);
      b.restitution[wall][l] = times.restitution;
      b.restitution_error[wall][l] = lane.sign(wall) * times.restitution;
      b.duration[wall][l] = times.duration;
      b.deepest[wall][l] = times.deepest;
    }
  }

  std::unique_ptr<InLanes<W>> block_;
  std::array<std::unique_ptr<Traveller>, W> inside_;
  std::vector<std::unique_ptr<Traveller>> waiting_;
  int occupied_ = 0;
};

}  // namespace sigmasweep::side_by_side
