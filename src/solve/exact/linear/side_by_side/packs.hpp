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
template <int W, bool HasUnequalMasses, template <int, bool> class InLanes>
class LanePack {
  using Block = InLanes<W, HasUnequalMasses>;

 public:
  explicit LanePack(int N) : block_(std::make_unique<Block>()) { block_->N = N; }

  Block& block() { return *block_; }
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
      if (inside_[l]) draw_noise(l);
    }
  }

  /// Whether the column in lane l is to be looked at.
  bool wants_look(int l) {
    if (!inside_[l]->lane.is_due(block_->contacts[l])) return false;
    double approach = 0.0;
    for (int k = 0; k < block_->N; ++k) approach = std::max(approach, block_->a[1][k][l]);
    return inside_[l]->lane.wants_look(block_->contacts[l], approach);
  }

  /// Whether the column in lane l, which goes by steps, may go by jumps.
  bool may_jump(int l) const {
    const std::uint64_t closed = block_->closed_bits[l];
    return !(closed & closed >> 1) &&
           inside_[l]->lane.isolated().may_jump(&block_->a[0][0][l], &block_->a[1][0][l], W, block_->N, closed);
  }

  /// The state of the column in lane l.
  LaneState state(int l) const {
    const Block& b = *block_;
    LaneState s(b.N);
    for (int k = 0; k < b.N; ++k) {
      s.x[k] = b.a[0][k][l];
      s.u[k] = b.a[1][k][l];
      for (int d = 0; d < disturbances; ++d) {
        s.disturbed[d].x[k] = b.d[0][k][d * W + l];
        s.disturbed[d].u[k] = b.d[1][k][d * W + l];
      }
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
    Block& b = *block_;
    const LaneState& s = inside_[l]->state;
    for (int k = 0; k < b.N; ++k) {
      b.a[0][k][l] = s.x[k];
      b.a[1][k][l] = s.u[k];
      b.inverse_mass[k][l] = inside_[l]->lane.inverse_mass(k);
      for (int d = 0; d < disturbances; ++d) {
        b.d[0][k][d * W + l] = s.disturbed[d].x[k];
        b.d[1][k][d * W + l] = s.disturbed[d].u[k];
      }
    }
    b.clock[l] = s.clock;
    b.wall_opened[l] = s.wall_opened;
    b.x_max[l] = s.x_max;
    b.contacts[l] = s.contacts;
    b.separated[l] = 0;
    b.active[l] = -1;
    put_own(inside_[l]->lane, s, b, l);
  }

  void draw_noise(int l) {
    Lane& lane = inside_[l]->lane;
    lane.next_step();
    for (int d = 0; d < disturbances; ++d)
      for (int word = 0; 32 * word < block_->N; ++word) {
        const std::uint64_t bits = lane.noise(d, word);
        block_->noise[0][word][d * W + l] = static_cast<std::uint32_t>(bits);
        block_->noise[1][word][d * W + l] = static_cast<std::uint32_t>(bits >> 32);
      }
  }

  using Steps = Columns<W, HasUnequalMasses>;
  using ByJumps = Jumps<W, HasUnequalMasses>;
  static void take_own(LaneState& s, const Steps& b, int l) {
    for (int k = 0; k < b.N; ++k) s.closed[k] = b.closed[k][l] != 0;
  }
  static void take_own(LaneState& s, const ByJumps& b, int l) {
    for (int k = 0; k < b.N; ++k) s.depth[k] = b.depth[k][l];
    s.wall_opens = b.wall_opens[l];
  }
  static void put_own(const Lane& lane, const LaneState& s, Steps& b, int l) {
    b.closed_bits[l] = 0;
    for (int k = 0; k < b.N; ++k) {
      const bool closed = s.closed[k] != 0;
      b.spring[k][l] = k == 0 ? lane.law().wall_spring : lane.law().spring;
      b.dashpot[k][l] = lane.isolated().contact(k).dashpot;
      b.acting_spring[k][l] = closed ? b.spring[k][l] : 0.0;
      b.acting_dashpot[k][l] = closed ? b.dashpot[k][l] : 0.0;
      for (int place = l; place < disturbances * W; place += W) {
        b.disturbed_spring[k][place] = static_cast<float>(b.acting_spring[k][l]);
        b.disturbed_dashpot[k][place] = static_cast<float>(b.acting_dashpot[k][l]);
      }
      b.closed[k][l] = closed ? -1 : 0;
      b.closed_bits[l] |= std::uint64_t(closed) << k;
      b.a[0][k][l] = closed ? std::max(s.x[k], 0.0) : std::min(s.x[k], 0.0);
    }
  }
  static void put_own(const Lane& lane, const LaneState& s, ByJumps& b, int l) {
    for (int k = 0; k < b.N; ++k) b.depth[k][l] = s.depth[k];
    b.wall_opens[l] = s.wall_opens;
    for (int k = 0; k < (HasUnequalMasses ? b.N : b.kinds); ++k) {
      const IsolatedContact& contact = lane.isolated().contact(k);
      b.restitution[k][l] = contact.restitution;
      for (int d = 0; d < disturbances; ++d)
        b.restitution_error[k][d * W + l] = static_cast<float>(lane.sign(d, k) * contact.restitution);
      b.duration[k][l] = contact.duration;
      b.deepest[k][l] = contact.deepest;
      b.share_below[k][l] = contact.share_below;
      b.share_above[k][l] = contact.share_above;
    }
  }

  std::unique_ptr<Block> block_;
  std::array<std::unique_ptr<Traveller>, W> inside_;
  std::vector<std::unique_ptr<Traveller>> waiting_;
  int occupied_ = 0;
};

}  // namespace sigmasweep::side_by_side
