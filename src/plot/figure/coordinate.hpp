#pragma once

#include <string>
#include <vector>

#include "sweep/expression/formula.hpp"

namespace sigmasweep::plot {

/// What is drawn along an axis: a field or an expression over fields.
class Coordinate {
 public:
  /// Throws UsageError if `text` is neither, or no number.
  explicit Coordinate(const std::string& text);
  double operator()(const Row& row) { return formula_(row); }
  std::string axis_label() const;
  std::string symbol() const;  ///< enhanced text
  bool uses(std::string_view name) const;
  bool has_unit() const;  ///< any of the fields has one

 private:
  std::string text_;
  const Field* field_;  ///< null for an expression
  Formula formula_;
};

/// Fields by name. Throws UsageError for one that is not there.
const Field& field_named(const std::string& name);

}  // namespace sigmasweep::plot
