#pragma once

#include <optional>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "sweep/expression/where.hpp"

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
