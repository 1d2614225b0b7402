#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sigmasweep/sweep/row.hpp"

/// The names, units and places of everything a row holds: the one list that the spec's keys, `where`, the table's
/// members, show, export and plot are made from.
namespace sigmasweep {

enum class FieldType : std::uint8_t { real, integer, unsigned_integer, integer32, method, wall, integrator, end, status };

struct Field {
  std::string_view name;
  std::string_view unit;     ///< SI; "1" where there is none
  std::string_view meaning;  ///< one line, for the table's attributes and help
  FieldType type;
  std::size_t offset;        ///< within Row
};

std::span<const Field> parameter_fields();
std::span<const Field> result_fields();
std::span<const Field> timing_fields();

/// The field of that name, from any of the three lists, or nullptr.
const Field* find_field(std::string_view name);

/// A field's value as a number (enumerators as their number), and as the text that users read.
double number(const Field& field, const Row& row);
std::string text(const Field& field, const Row& row);

}  // namespace sigmasweep
