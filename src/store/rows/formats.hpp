#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "store/rows/row_writer.hpp"

namespace sigmasweep {

/// All formats of rows; the first one is the default.
std::span<const RowFormat> row_formats();

/// The format of this name; nothing if there is none.
std::optional<RowFormat> row_format(std::string_view name);

}  // namespace sigmasweep
