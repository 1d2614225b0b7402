#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/row.hpp"

/// The names, units and places of everything a row holds: the one list that the spec's keys, `where`, the table's
/// members, show, export and plot are made from.
namespace sigmasweep {

enum class FieldType : std::uint8_t {
  real,
  integer,
  unsigned_integer,
  integer32,
  method,
  wall,
  integrator,
  end,
  status,
  law,
  material,
  ed_rule,
  flag,
  geometry,
  side_walls
};

struct Field {
  std::string_view name;
  std::string_view unit;     ///< SI; "1" where there is none
  std::string_view meaning;  ///< one line, for the table's attributes and help
  FieldType type;
  std::size_t offset;  ///< within Row
};

std::span<const Field> parameter_fields();
std::span<const Field> result_fields();
std::span<const Field> timing_fields();

/// The three lists one after the other; and their names.
std::vector<Field> all_fields();
std::vector<std::string_view> field_names();

/// The field of that name, from any of the three lists, or nullptr.
const Field* find_field(std::string_view name);

/// A field's value as a number (enumerators as their number), and as the text that users read: an enumerator's name,
/// the shortest decimal that reads back as the same double, nan, inf.
double number(const Field& field, const Row& row);
std::string text(const Field& field, const Row& row);

/// Sets a field from a number(); integers must be whole, enumerators one of their numbers.
void set_number(const Field& field, Row& row, double value);

/// The names of a field's values if it is an enumeration, in the order of their numbers; empty for numbers.
std::span<const std::string_view> enumerators(FieldType type);

}  // namespace sigmasweep
