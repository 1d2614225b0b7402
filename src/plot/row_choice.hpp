#pragma once

#include <optional>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "sweep/expression/where.hpp"

namespace sigmasweep {

/// The condition `where` of a plot: whether it shows a row. An empty condition is always true.
class RowChoice {
 public:
  /// The condition may name `fields`. Throws UsageError, which quotes the condition.
  explicit RowChoice(const std::string& where, std::span<const Field> fields = all_fields());
  bool operator()(const Row& row) { return !where_ || (*where_)(row); }

 private:
  std::optional<Where> where_;
};

}  // namespace sigmasweep
