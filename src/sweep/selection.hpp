#pragma once

#include <cstdint>
#include <vector>

namespace sigmasweep {

/// A subset of 0, 1, 2, ..., a bit for each number. A running count every 4096 bits finds the k-th member in O(log).
class Selection {
 public:
  /// Adds the next number to the set, or leaves it out.
  void push(bool member);
  std::uint64_t size() const { return size_; }
  /// The k-th member, k < size().
  std::uint64_t operator[](std::uint64_t k) const;

 private:
  std::vector<std::uint64_t> words_;   ///< number i is bit i % 64 of word i / 64
  std::vector<std::uint64_t> before_;  ///< number of members before each block of words
  std::uint64_t pushed_ = 0, size_ = 0;
};

}  // namespace sigmasweep
