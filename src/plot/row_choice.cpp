#include "plot/row_choice.hpp"

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

RowChoice::RowChoice(const std::string& where, std::span<const Field> fields) {
  try {
    if (!where.empty()) where_.emplace(where, fields);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("plot: '{}': {}", where, error.what()));
  }
}

}  // namespace sigmasweep
