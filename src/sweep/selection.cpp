#include "sweep/selection.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace sigmasweep {
namespace {
constexpr std::uint64_t words_per_block = 64;
}

void Selection::push(bool member) {
  if (pushed_ % 64 == 0) {
    if (words_.size() % words_per_block == 0) before_.push_back(size_);
    words_.push_back(0);
  }
  words_.back() |= std::uint64_t{member} << pushed_ % 64;
  size_ += member;
  ++pushed_;
}

std::uint64_t Selection::operator[](std::uint64_t k) const {
  assert(k < size_);
  const auto block = std::prev(std::upper_bound(before_.begin(), before_.end(), k)) - before_.begin();
  std::uint64_t left = k - before_[block];
  std::uint64_t word = static_cast<std::uint64_t>(block) * words_per_block;
  for (; left >= static_cast<std::uint64_t>(std::popcount(words_[word])); ++word)
    left -= static_cast<std::uint64_t>(std::popcount(words_[word]));
  std::uint64_t bits = words_[word];
  for (; left > 0; --left) bits &= bits - 1;
  return word * 64 + static_cast<std::uint64_t>(std::countr_zero(bits));
}

}  // namespace sigmasweep
