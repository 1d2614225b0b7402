#pragma once

#include <cstdint>
#include <vector>

namespace sigmasweep {

/// A subset of 0, 1, 2, ... told one by one: a bit each, and a running count every 4096 bits to find the k-th member
/// in O(log).
class Selection {
 public:
  /// Says whether the next number is in the set.
  void push(bool member);
  std::uint64_t size() const { return size_; }
  /// The k-th member, k < size().
  std::uint64_t operator[](std::uint64_t k) const;

 private:
  std::vector<std::uint64_t> words_;   ///< bit i % 64 of word i / 64
  std::vector<std::uint64_t> before_;  ///< members before each block of words
  std::uint64_t told_ = 0, size_ = 0;
};

}  // namespace sigmasweep
