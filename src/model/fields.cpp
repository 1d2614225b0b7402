#include "sigmasweep/model/fields.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "model/fields/parameters.hpp"
#include "model/fields/results.hpp"

namespace sigmasweep {
namespace {

static_assert(std::is_standard_layout_v<Row> && std::is_trivially_copyable_v<Row>);

/// The fields of a part of a row, as fields of the row. `offset`: of the part within Row.
template <class Part, std::size_t n>
constexpr std::array<Field, n> in_row(const std::array<FieldOf<Part>, n>& table, std::size_t offset) {
  std::array<Field, n> fields{};
  for (std::size_t i = 0; i < n; ++i) {
    const FieldOf<Part>& f = table[i];
    fields[i] = {f.name,   f.type,     offset + f.offset, f.unit,    f.meaning,
                 f.symbol, f.quantity, f.applies,         f.allowed, f.always_column};
  }
  return fields;
}

constexpr auto parameters = in_row(table_of_parameters, offsetof(Row, parameters));
constexpr auto results = in_row(table_of_results, offsetof(Row, result));
constexpr auto timings = in_row(table_of_timings, offsetof(Row, timing));

template <class T>
T load(const std::byte* member) {
  T value;
  std::memcpy(&value, member, sizeof value);
  return value;
}

template <class T>
void store(std::byte* member, double number) {
  const T value = static_cast<T>(number);
  std::memcpy(member, &value, sizeof value);
}

}  // namespace

std::span<const Field> parameter_fields() { return parameters; }
std::span<const Field> result_fields() { return results; }
std::span<const Field> timing_fields() { return timings; }
std::span<const ParameterField> fields_of_parameters() { return table_of_parameters; }

std::vector<Field> all_fields() {
  std::vector<Field> all;
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    all.insert(all.end(), fields.begin(), fields.end());
  return all;
}

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const Field& field : all_fields()) names.push_back(field.name);
  return names;
}

const Field* find_field(std::string_view name) {
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : fields)
      if (field.name == name) return &field;
  return nullptr;
}

const ParameterField* find_parameter(std::string_view name) {
  const auto field = std::ranges::find(table_of_parameters, name, &ParameterField::name);
  return field == table_of_parameters.end() ? nullptr : &*field;
}

double field_access::number(const FieldType& type, const std::byte* member) {
  switch (type.storage) {
    case FieldType::Storage::real: return load<double>(member);
    case FieldType::Storage::integer: return static_cast<double>(load<std::int64_t>(member));
    case FieldType::Storage::unsigned_integer: return static_cast<double>(load<std::uint64_t>(member));
    case FieldType::Storage::integer32: return load<std::int32_t>(member);
    case FieldType::Storage::enumeration: break;
  }
  return load<std::uint8_t>(member);
}

void field_access::set_number(const FieldType& type, std::byte* member, double value) {
  switch (type.storage) {
    case FieldType::Storage::real: return store<double>(member, value);
    case FieldType::Storage::integer: return store<std::int64_t>(member, value);
    case FieldType::Storage::unsigned_integer: return store<std::uint64_t>(member, value);
    case FieldType::Storage::integer32: return store<std::int32_t>(member, value);
    case FieldType::Storage::enumeration: break;
  }
  assert(value < static_cast<double>(type.names.size()));
  store<std::uint8_t>(member, value);
}

std::string field_access::text(const FieldType& type, const std::byte* member) {
  switch (type.storage) {
    case FieldType::Storage::real: return fmt::format("{}", load<double>(member));
    case FieldType::Storage::integer: return fmt::format("{}", load<std::int64_t>(member));
    case FieldType::Storage::unsigned_integer: return fmt::format("{}", load<std::uint64_t>(member));
    case FieldType::Storage::integer32: return fmt::format("{}", load<std::int32_t>(member));
    case FieldType::Storage::enumeration: break;
  }
  const auto value = load<std::uint8_t>(member);
  return value < type.names.size() ? std::string(type.names[value]) : fmt::format("{}", value);
}

template <class Owner>
std::string why_refused(const FieldOf<Owner>& field, double value, std::string_view text) {
  const AllowedValues& allowed = field.allowed;
  if (!allowed.contain || allowed.contain(value)) return {};
  return fmt::format("{} = {} is not allowed: it must be {}.", field.name, text, allowed.must_be);
}
template std::string why_refused(const Field&, double, std::string_view);
template std::string why_refused(const ParameterField&, double, std::string_view);

}  // namespace sigmasweep
