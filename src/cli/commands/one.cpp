#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/json_row.hpp"
#include "engine/compute.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {
namespace {

/// The value as TOML writes it: what a number is was checked before.
std::string toml_value(const Field& field, const std::string& typed) {
  if (field.type == FieldType::flag) return typed;
  if (!enumerators(field.type).empty()) return fmt::format("\"{}\"", typed);
  return field.type == FieldType::real ? fmt::format("{}", std::stod(typed)) : typed;
}

/// The tuple, as a sweep of one row: the spec knows what may be given together and says what is wrong.
Sweep sweep_of(const OneOptions& options) {
  const std::string file = "command line";
  std::string spec = "[sweep]\n";
  for (const Field& field : parameter_fields())
    if (const auto value = options.given.find(field.name); value != options.given.end())
      spec += fmt::format("{} = {}\n", field.name, toml_value(field, value->second));
  try {
    return Sweep::parse(spec, file);
  } catch (const SpecError& error) {  // "command line:3: sweep.s0 = -1: why"
    std::string message = error.what();
    if (const auto place = message.find(": "); message.starts_with(file) && place != std::string::npos)
      message.erase(0, place + 2);
    for (const std::string_view prefix : {"sweep.", "sweep: "})
      if (message.starts_with(prefix)) message.erase(0, prefix.size());
    throw UsageError(message + " (see sigmasweep one --help)");
  }
}

std::string readable(const Field& field, const Row& row) {
  const std::string value =
      field.type == FieldType::real ? fmt::format("{:.10g}", number(field, row)) : text(field, row);
  return field.unit == "1" ? value : fmt::format("{} {}", value, field.unit);
}

/// What has an error comes with it.
std::string with_error(const Field& field, const Row& row) {
  const SimulationResult& c = row.result;
  if (field.name == "eps_eff") return fmt::format("{:.12g} +- {:.1g}", c.eps_eff, c.eps_eff_error);
  if (field.name == "h_cm") return fmt::format("{:.8g} +- {:.1g} m", c.vibration.h_cm, c.vibration.h_cm_error);
  return readable(field, row);
}

bool is_result(const Field& field) {
  return std::ranges::find(result_fields(), field.name, &Field::name) != result_fields().end();
}

void print_result(const std::vector<Field>& columns, const Row& row) {
  std::size_t names = 0, values = 24;
  for (const Field& field : columns) {
    names = std::max(names, field.name.size());
    values = std::max(values, with_error(field, row).size());
  }
  bool in_results = false;
  for (const Field& field : columns) {
    if (field.name == "eps_eff_error" || field.name == "h_cm_error") continue;
    if (is_result(field) && !in_results) fmt::print("\n");
    in_results = is_result(field);
    fmt::print("{:<{}} {:<{}} {}\n", field.name, names, with_error(field, row), values, field.meaning);
  }
  fmt::print("\n{:.3g} ms of computing\n", 1e3 * row.timing.run_time);
}

}  // namespace

int one(const OneOptions& options) {
  const Sweep sweep = sweep_of(options);
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  const Row row = *compute_row({.index = 0, .parameters = sweep.at(0)}, 0, no_limit);
  std::vector<Field> columns;  // what a table would have, what was given, and what follows from it
  for (const Field& field : parameter_fields()) {
    const bool column = std::ranges::any_of(sweep.columns(), [&](const Field& f) { return f.name == field.name; });
    const bool follows = row.parameters.K_over_m > 0.0 && (field.name == "K_over_m" || field.name == "D_n");
    if (column || follows || options.given.contains(field.name)) columns.push_back(field);
  }
  for (const Field& field : result_fields())
    if (applies_to(field, row.parameters)) columns.push_back(field);
  if (options.json)
    fmt::print("{}\n", json_of(columns, row).dump(2));
  else
    print_result(columns, row);
  return is_success(row.result.status) ? 0 : 1;
}

}  // namespace sigmasweep
