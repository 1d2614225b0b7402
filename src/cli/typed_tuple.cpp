#include "cli/typed_tuple.hpp"

#include <fmt/format.h>

#include "base/text/numbers.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/names.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep {
namespace {

/// The value in TOML.
std::string toml_value(const Field& field, const std::string& typed) {
  if (field.type == FieldType::of<Flag>()) return typed;
  if (!enumerators(field.type).empty()) return fmt::format("\"{}\"", typed);
  if (field.type != FieldType::real)
    if (const auto whole = parse_whole_number(typed)) return fmt::format("{}", *whole);
  return fmt::format("{}", parse_number(typed).value());
}

}  // namespace

Sweep sweep_of(const TypedParameters& given, std::string_view command) {
  const std::string file = "command line";
  std::string spec = "[sweep]\n";
  for (const Field& field : parameter_fields())
    if (const auto value = given.find(field.name); value != given.end())
      spec += fmt::format("{} = {}\n", field.name, toml_value(field, value->second));
  try {
    return Sweep::parse(spec, file);
  } catch (const SpecError& error) {
    throw UsageError(fmt::format("{} (see sigmasweep {} --help)", spec::without_places(error.what(), file), command));
  }
}

}  // namespace sigmasweep
