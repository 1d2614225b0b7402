#pragma once

#include <cstdint>
#include <map>

namespace sigmasweep {

/// The number of attempts at rows that were tried before and are missing, by row.
using Attempts = std::map<std::uint64_t, std::int32_t>;

/// The number of the attempt at a row that is made now, from 1.
inline std::int32_t next_attempt(const Attempts& attempts, std::uint64_t row) {
  const auto tried = attempts.find(row);
  return tried == attempts.end() ? 1 : tried->second + 1;
}

}  // namespace sigmasweep
