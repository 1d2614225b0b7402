#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <string>
#include <vector>

#include "assembly/diameters.hpp"
#include "assembly/springs.hpp"
#include "base/exit_codes.hpp"
#include "base/text/numbers.hpp"
#include "base/thread_clock.hpp"
#include "cli/command.hpp"
#include "cli/typed_tuple.hpp"
#include "engine/report/remarks.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/names.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sigmasweep/solve/cost.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/rows/json.hpp"

namespace sigmasweep {
namespace {

struct OneOptions {
  TypedParameters given;
  bool json = false;
};

std::string readable(const Field& field, const Row& row) {
  const std::string value =
      field.type == FieldType::real ? fmt::format("{:.10g}", number(field, row)) : text(field, row);
  return field.unit == "1" ? value : fmt::format("{} {}", value, field.unit);
}

/// The value of a field with its unit, and with its error bar if it has one.
std::string with_error(const Field& field, const Row& row) {
  const SimulationResult& c = row.result;
  if (field.name == "eps_eff") return fmt::format("{:.12g} +- {:.1g}", c.eps_eff, c.eps_eff_error);
  if (field.name == "Er_Ef") return fmt::format("{:.10g} +- {:.1g}", c.Er_Ef, c.Er_Ef_error);
  if (field.name == "v_cm") return fmt::format("{:.10g} +- {:.1g}", c.v_cm, c.v_cm_error);
  if (field.name == "h_cm") return fmt::format("{:.8g} +- {:.1g} m", c.vibration.h_cm, c.vibration.h_cm_error);
  return readable(field, row);
}

bool is_result(const Field& field) {
  return std::ranges::find(result_fields(), field.name, &Field::name) != result_fields().end();
}

/// The first diameters; all of them are in JSON.
void print_diameters(const std::vector<double>& diameters, std::size_t width) {
  constexpr std::size_t most = 10;
  const std::size_t shown = std::min(most, diameters.size());
  fmt::print("{:<{}} {:.6g} m{}\n", "diameters", width, fmt::join(diameters.begin(), diameters.begin() + shown, ", "),
             shown < diameters.size() ? ", ... (--json has all)" : "");
}

void print_result(const std::vector<Field>& columns, const Row& row, const std::vector<double>& diameters) {
  std::size_t names = 0, values = 24;
  for (const Field& field : columns) {
    names = std::max(names, field.name.size());
    values = std::max(values, with_error(field, row).size());
  }
  bool in_results = false;
  for (const Field& field : columns) {
    if (field.name.ends_with("_error")) continue;  // beside the value
    if (is_result(field) && !in_results) {
      if (!diameters.empty()) print_diameters(diameters, names);
      fmt::print("\n");
    }
    in_results = is_result(field);
    fmt::print("{:<{}} {:<{}} {}\n", field.name, names, with_error(field, row), values, field.meaning);
  }
  fmt::print("\n{:.3g} ms of computing\n", 1e3 * row.timing.run_time);
}

/// The columns of a table, stiffness and damping, and all results that the tuple has.
std::vector<Field> shown_fields(const Sweep& sweep, const Row& row) {
  std::vector<Field> fields;
  for (const Field& field : parameter_fields()) {
    const bool is_column = std::ranges::find(sweep.columns(), field.name, &Field::name) != sweep.columns().end();
    const bool is_spring = row.parameters.K_over_m > 0.0 && (field.name == "K_over_m" || field.name == "D_n");
    if (is_column || is_spring) fields.push_back(field);
  }
  for (const Field& field : result_fields())
    if (applies_to(field, row.parameters)) fields.push_back(field);
  return fields;
}

int one(const OneOptions& options) {
  const Sweep sweep = sweep_of(options.given, "one");
  const Parameters parameters = sweep.at(0);
  Row row{.index = 0, .parameters = with_springs(parameters), .result = {}, .timing = {}};
  const double start = thread_seconds();
  row.result = simulate(parameters);
  row.timing = {.run_time = thread_seconds() - start, .predicted_time = predicted_time(parameters), .rank = 0};
  const std::vector<Field> fields = shown_fields(sweep, row);
  const std::vector<double> unequal = diameters(parameters);
  for (const std::string& remark : remarks_on(sweep)) fmt::print(stderr, "sigmasweep: {}\n", remark);
  if (options.json) {
    auto document = json_of(fields, row);
    if (!unequal.empty()) document["diameters"] = unequal;
    fmt::print("{}\n", document.dump(2));
  } else {
    print_result(fields, row, unequal);
  }
  return is_success(row.result.status) ? exit_code::success : exit_code::some_rows_failed;
}

/// Names of a parameter's option: "--steps-per-tc", and the same with underscores as in a spec.
std::string option_names(std::string_view name) {
  std::string dashed(name);
  std::ranges::replace(dashed, '_', '-');
  return dashed == name ? "--" + dashed : fmt::format("--{},--{}", dashed, name);
}

/// The message about a text that is not a real or whole number; empty if it is one. The spec checks the value.
std::string number_complaint(const std::string& typed, bool real) {
  if (real ? parse_number(typed).has_value() : parse_whole_number(typed).has_value()) return {};
  return fmt::format("'{}' is not a {}number{}", typed, real ? "" : "whole ", number_hint(typed));
}

/// The option of a parameter. Its value is a number, or a name of the parameter's enumeration.
Option option_of(const Field& field) {
  const std::string unit = field.unit == "1" ? "" : fmt::format(" ({})", field.unit);
  Option option{option_names(field.name), std::string(field.meaning) + unit, ""};
  const bool real = field.type == FieldType::real;
  if (const auto names = enumerators(field.type); !names.empty()) {
    option.type_name = fmt::format("{}", fmt::join(names, "|"));
    option.choices.assign(names.begin(), names.end());
  } else {
    option.type_name = real ? "NUMBER" : "INTEGER";
    option.complaint = [real](const std::string& typed) { return number_complaint(typed, real); };
  }
  return option;
}

void declare(OptionSet& set, OneOptions& options) {
  for (const Field& field : parameter_fields())
    set.add(option_of(field), [&options, name = field.name](const std::string& typed) {
      options.given[name] = typed;
      return true;
    });
  set.add_flag("--json", "One JSON document: field names and values", options.json);
}

}  // namespace

Command one_command() {
  return make_command(
      "one", "Compute one tuple, now",
      "\nA column needs v0, N, s0 or sigma, and tc and epsilon, or K-over-m and D-n, or a material. Other parameters\n"
      "have defaults (method md, law hooke, integrator exact, wall paper). A vibrated column needs alpha or A0, but\n"
      "neither v0 nor a gap. A lattice needs rows instead of N (default: 13 columns).\n\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --s0 1e-6 --N 10 --epsilon 0.9\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --sigma 0.05 --N 10 --epsilon 0.9 --integrator gear5 --steps-per-tc 500\n"
      "  sigmasweep one --v0 1 --tc 2e-5 --sigma 0.05 --N 10 --epsilon 0.9 --integrator gear5 --tolerance 1e-4\n"
      "  sigmasweep one --v0 1 --s0 0 --N 1 --law hertz --material steel\n"
      "  sigmasweep one --geometry vibrated-column --alpha 4 --frequency 20 --tc 1e-4 --N 10 --epsilon 0.92\n"
      "  sigmasweep one --geometry lattice --rows 10 --v0 0.05 --tc 2e-5 --s0 1e-7 --epsilon 0.9",
      declare, one);
}

}  // namespace sigmasweep
