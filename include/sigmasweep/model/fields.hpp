#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/row.hpp"

/// The registry of fields: names, units, symbols, relevance and validity of all members of a row. The spec's keys,
/// `where`, the table's members, show, export and plot are made from it.
namespace sigmasweep {

/// The type of a field: a number, or an enumeration, which is stored as one byte.
struct FieldType {
  enum class Storage : std::uint8_t { real, integer, unsigned_integer, integer32, enumeration };

  Storage storage = Storage::real;
  std::span<const std::string_view> names{};  ///< enumerators of an enumeration, in the order of their numbers

  static const FieldType real, integer, unsigned_integer, integer32;
  /// The type of a member of type T: double, a whole number or an enumeration.
  template <class T>
  static constexpr FieldType of();

  friend constexpr bool operator==(const FieldType& a, const FieldType& b) {
    return a.storage == b.storage && a.names.data() == b.names.data();
  }
};

inline constexpr FieldType FieldType::real{Storage::real, {}}, FieldType::integer{Storage::integer, {}},
    FieldType::unsigned_integer{Storage::unsigned_integer, {}}, FieldType::integer32{Storage::integer32, {}};

template <class T>
constexpr FieldType FieldType::of() {
  if constexpr (std::is_enum_v<T>)
    return {Storage::enumeration, names_of<T>()};
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return integer;
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return unsigned_integer;
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return integer32;
  else {
    static_assert(std::is_same_v<T, double>);
    return real;
  }
}

/// A condition on tuples that use a field.
struct Condition {
  bool (*holds)(const Parameters&);
  std::string_view needs;  ///< the condition in messages: "method = 'md'"
};

/// The values that a parameter may have with any values of the others.
struct AllowedValues {
  bool (*contain)(double) = nullptr;             ///< null: all
  std::string_view must_be{};                    ///< the values in messages: "a finite speed > 0 m/s"
  bool (*checked)(const Parameters&) = nullptr;  ///< the tuples whose value is checked; null: all
};

/// A field of an Owner: a member of Parameters, SimulationResult or Timing, or of a Row, which has the members of all
/// three.
template <class Owner>
struct FieldOf {
  std::string_view name;
  FieldType type;
  std::size_t offset;           ///< place of the member within Owner, bytes
  std::string_view unit{};      ///< SI; "1" if the field is dimensionless
  std::string_view meaning{};   ///< one line for help and the table's attributes
  std::string_view symbol{};    ///< in gnuplot's markup; empty: the name
  std::string_view quantity{};  ///< label of an axis, in gnuplot's markup, without the unit; empty: the symbol
  std::array<const Condition*, 2> applies{};  ///< conditions on tuples that use the field; null: none
  AllowedValues allowed{};
  const Condition* always_column{};  ///< tuples whose tables have the parameter even if it is no axis; null: none
};
using Field = FieldOf<Row>;
using ParameterField = FieldOf<Parameters>;

std::span<const Field> parameter_fields();
std::span<const Field> result_fields();
std::span<const Field> timing_fields();

/// The parameters as members of Parameters, in the order of parameter_fields().
std::span<const ParameterField> fields_of_parameters();

/// Parameters, results and timings, and their names.
std::vector<Field> all_fields();
std::vector<std::string_view> field_names();

/// The parameter, result or timing of this name, or nullptr.
const Field* find_field(std::string_view name);
const ParameterField* find_parameter(std::string_view name);

namespace field_access {
double number(const FieldType& type, const std::byte* member);
void set_number(const FieldType& type, std::byte* member, double value);
std::string text(const FieldType& type, const std::byte* member);

template <class Owner>
const std::byte* member(const FieldOf<Owner>& field, const Owner& owner) {
  return reinterpret_cast<const std::byte*>(&owner) + field.offset;
}
}  // namespace field_access

/// The value of a field as a number; for an enumerator its number.
template <class Owner>
double number(const FieldOf<Owner>& field, const Owner& owner) {
  return field_access::number(field.type, field_access::member(field, owner));
}

/// The value of a field as text: the enumerator's name; or the shortest decimal that reads back as the same double, nan
/// or inf.
template <class Owner>
std::string text(const FieldOf<Owner>& field, const Owner& owner) {
  return field_access::text(field.type, field_access::member(field, owner));
}

/// Sets the value of a field from a number(), which must be whole for an integer, and that of an enumerator for an
/// enumeration.
template <class Owner>
void set_number(const FieldOf<Owner>& field, Owner& owner, double value) {
  field_access::set_number(field.type, reinterpret_cast<std::byte*>(&owner) + field.offset, value);
}

/// The reason why the field cannot have this value with any values of the others: one sentence with the field, the
/// value as `text` and the allowed values. It is empty if the value is allowed.
template <class Owner>
std::string why_refused(const FieldOf<Owner>& field, double value, std::string_view text);
extern template std::string why_refused(const Field&, double, std::string_view);
extern template std::string why_refused(const ParameterField&, double, std::string_view);

/// The enumerators of a type, in the order of their numbers; empty for numbers.
constexpr std::span<const std::string_view> enumerators(const FieldType& type) { return type.names; }

}  // namespace sigmasweep
