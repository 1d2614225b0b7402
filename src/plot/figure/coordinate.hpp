#pragma once

#include <string>
#include <vector>

#include "sweep/expression/formula.hpp"

namespace sigmasweep::plot {

/// The quantity along an axis: a field or an expression over fields.
class Coordinate {
 public:
  /// Throws UsageError if `text` is neither a field nor an expression, or if it is not a number.
  explicit Coordinate(const std::string& text);
  double operator()(const Row& row) { return formula_(row); }
  std::string axis_label() const;
  std::string symbol() const;              ///< enhanced text
  bool uses(std::string_view name) const;  ///< the expression names the field
  bool has_unit() const;                   ///< one of the fields has a unit

 private:
  std::string text_;
  const Field* field_;  ///< null for an expression
  Formula formula_;
};

/// The field with this name. Throws UsageError if there is none.
const Field& field_named(const std::string& name);

}  // namespace sigmasweep::plot
