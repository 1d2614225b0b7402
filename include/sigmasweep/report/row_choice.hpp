#pragma once

#include <optional>
#include <span>
#include <string>

#include "sigmasweep/sweep/fields.hpp"
#include "sigmasweep/sweep/row.hpp"
#include "sigmasweep/sweep/where.hpp"

namespace sigmasweep {

/// The rows that a plot is about: those that satisfy its `where`; all if that is empty.
class RowChoice {
 public:
  /// `fields`: those that the condition may name. Throws UsageError, which quotes the condition.
  explicit RowChoice(const std::string& where, std::span<const Field> fields = all_fields());
  bool operator()(const Row& row) { return !where_ || (*where_)(row); }

 private:
  std::optional<Where> where_;
};

}  // namespace sigmasweep
