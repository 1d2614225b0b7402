#include "plot/figure/coordinate.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>

#include "base/spelling.hpp"
#include "plot/labels.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::plot {
namespace {

Formula formula_of(const std::string& text) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (std::ranges::all_of(text, is_letter) && !enumerators(field_named(text).type).empty())
    throw UsageError(fmt::format("plot: '{}' is not a number and cannot be an axis", text));
  try {
    return Formula(text, all_fields());
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("plot: '{}': {}", text, error.what()));
  }
}

}  // namespace

const Field& field_named(const std::string& name) {
  if (const Field* field = find_field(name)) return *field;
  throw UsageError(fmt::format("plot: there is no field '{}'{}", name, hint(name, field_names())));
}

Coordinate::Coordinate(const std::string& text) : text_(text), field_(find_field(text)), formula_(formula_of(text)) {}

std::string Coordinate::axis_label() const { return field_ ? plot::axis_label(*field_) : symbol(); }
std::string Coordinate::symbol() const { return field_ ? symbol_of(*field_) : expression_label(text_); }

bool Coordinate::uses(std::string_view name) const {
  return std::ranges::any_of(formula_.used(), [&](const Field& field) { return field.name == name; });
}

bool Coordinate::has_unit() const {
  return std::ranges::any_of(formula_.used(), [](const Field& field) { return field.unit != "1"; });
}

}  // namespace sigmasweep::plot
