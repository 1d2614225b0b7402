#include "engine/report/duplicate_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "sigmasweep/sweep/content_key.hpp"

namespace sigmasweep {

std::string duplicate_warning(const Sweep& sweep) {
  constexpr std::uint64_t most = 200'000;
  const std::uint64_t rows = std::min(sweep.size(), most);
  std::unordered_map<std::uint64_t, std::uint64_t> known;
  known.reserve(rows);
  std::uint64_t repeated = 0, first = 0, second = 0;
  for (std::uint64_t row = 0; row < rows; ++row) {
    const auto [tuple, is_new] = known.emplace(content_key(sweep.at(row)), row);
    if (is_new || ++repeated > 1) continue;
    first = tuple->second;
    second = row;
  }
  if (repeated == 0) return {};
  return fmt::format(
      "warning: {} of {}{} rows repeat the tuple of another row (row {} that of row {}): does an axis have "
      "a value twice?",
      repeated, rows < sweep.size() ? "the first " : "", rows, second, first);
}

}  // namespace sigmasweep
