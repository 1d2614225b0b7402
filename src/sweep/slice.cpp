#include "sweep/slice.hpp"

#include "base/random.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t places_key = 0x736c696365;  // must not change: another key would make other slices

}  // namespace

std::uint64_t Slice::row(std::uint64_t k) const {
  return k * count + (index + random_bits(places_key, k) % count) % count;
}

Slice Slice::with(std::uint64_t row, std::uint64_t count) {
  const std::uint64_t turn = random_bits(places_key, row / count) % count;
  return {(row % count + count - turn) % count, count};
}

std::optional<std::uint64_t> Slice::place(std::uint64_t row_) const {
  return with(row_, count) == *this ? std::optional(row_ / count) : std::nullopt;
}

std::uint64_t Slice::size(std::uint64_t total) const {
  const std::uint64_t whole = total / count;
  return whole + (row(whole) < total ? 1 : 0);  // the last rows, fewer than `count`, go to some slices only
}

}  // namespace sigmasweep
