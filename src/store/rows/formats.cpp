#include "store/rows/formats.hpp"

#include <algorithm>
#include <array>

/// The formats of rows; the first one is the default. A file of this folder defines NAME_format().
// clang-format off
#define SIGMASWEEP_ROW_FORMATS(X) \
  X(csv) \
  X(json) \
  X(jsonl) \
  /* a line for each */
// clang-format on

namespace sigmasweep {

#define SIGMASWEEP_DECLARE(name) RowFormat name##_format();
SIGMASWEEP_ROW_FORMATS(SIGMASWEEP_DECLARE)

std::span<const RowFormat> row_formats() {
#define SIGMASWEEP_MAKE(name) name##_format(),
  static const auto formats = std::to_array<RowFormat>({SIGMASWEEP_ROW_FORMATS(SIGMASWEEP_MAKE)});
  return formats;
}

std::optional<RowFormat> row_format(std::string_view name) {
  const auto found = std::ranges::find(row_formats(), name, &RowFormat::name);
  if (found == row_formats().end()) return std::nullopt;
  return *found;
}

}  // namespace sigmasweep
