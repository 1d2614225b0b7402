#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace sigmasweep {

/// The earliest of n times, as a complete binary tree of minima. A change of one time takes O(log n).
template <class Real>
class Tournament {
 public:
  explicit Tournament(std::size_t players) {
    while (leaves_ < players) leaves_ *= 2;
    time_.assign(leaves_, std::numeric_limits<Real>::infinity());
    winner_.resize(2 * leaves_);
    for (std::size_t i = 0; i < leaves_; ++i) winner_[leaves_ + i] = i;
    for (std::size_t node = leaves_ - 1; node >= 1; --node) winner_[node] = winner_[2 * node];
  }

  void set(std::size_t player, const Real& time) {
    if (time_[player] == time) return;
    time_[player] = time;
    for (std::size_t node = (leaves_ + player) / 2; node >= 1; node /= 2) {
      const std::size_t left = winner_[2 * node], right = winner_[2 * node + 1];
      winner_[node] = time_[right] < time_[left] ? right : left;
    }
  }
  void remove(std::size_t player) { set(player, std::numeric_limits<Real>::infinity()); }

  /// The index of the earliest time; of equal times the smallest index.
  std::size_t first() const { return winner_[1]; }
  const Real& time_of(std::size_t player) const { return time_[player]; }

 private:
  std::size_t leaves_ = 2;
  std::vector<Real> time_;
  std::vector<std::size_t> winner_;
};

}  // namespace sigmasweep
