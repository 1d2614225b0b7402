#include "sweep/reference/reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sigmasweep/model/law.hpp"
#include "sweep/reference/parameter.hpp"
#include "sweep/spec/document.hpp"
#include "sweep/spec/plot.hpp"
#include "sweep/spec/tuples/axis.hpp"

namespace sigmasweep {
namespace {

using spec::KeyForm;
using spec::KeyInfo;

std::string_view name_of(KeyForm form) {
  switch (form) {
    case KeyForm::text: return "text";
    case KeyForm::number: return "number";
    case KeyForm::whole_number: return "whole number";
    case KeyForm::truth: return "true or false";
    case KeyForm::choice: return "name";
    case KeyForm::fields: return "field, or a list of fields";
    case KeyForm::expression: return "expression";
    case KeyForm::condition: return "condition";
    case KeyForm::point: return "point";
    case KeyForm::numbers: return "list of numbers";
    case KeyForm::choices: return "list of names";
    case KeyForm::groups: return "list of groups";
    case KeyForm::names: return "list of parameters";
    case KeyForm::table: return "table";
    case KeyForm::tables: return "list of tables";
    case KeyForm::one_or_several: return "table, or several";
  }
  return {};
}

std::string choices(std::span<const std::string_view> names) {
  return names.empty() ? "" : fmt::format(": `\"{}\"`", fmt::join(names, "\"`, `\""));
}

std::string lines_of(const std::vector<KeyInfo>& keys, const std::string& indent = "") {
  std::string text;
  for (const KeyInfo& key : keys) {
    text += fmt::format("{}- `{}` ({}{}): {}", indent, key.name, name_of(key.form), choices(key.choices), key.meaning);
    text += key.usual.empty() ? "\n" : fmt::format("; default: {}\n", key.usual);
    if (key.keys != nullptr) text += lines_of(key.keys(), indent + "  ");
  }
  return text;
}

std::string lines_of_parameters() {
  std::string text;
  for (const ParameterField& field : fields_of_parameters()) {
    const bool truth = field.type == FieldType::of<Flag>();
    const std::string names = truth ? ": `true`, `false`" : choices(enumerators(field.type));
    text += fmt::format("- `{}`{}: {}\n", field.name, names.empty() ? "" : fmt::format(" ({})", names.substr(2)),
                        parameter_line(field));
  }
  return text;
}

std::string lines_of_laws() {
  std::string text;
  for (const LawInfo& law : laws) {
    text += fmt::format("- `\"{}\"`: {}", law.name, law.meaning);
    if (!law.free_exponents) text += fmt::format("; beta = {}, gamma = {}", law.exponents.beta, law.exponents.gamma);
    text += "\n";
  }
  return text;
}

std::string lines_of(std::span<const Field> fields) {
  std::string text;
  for (const Field& field : fields) {
    text += fmt::format("- `{}`: {}", field.name, field.meaning);
    if (field.unit != "1") text += fmt::format(", {}", field.unit);
    if (const auto names = enumerators(field.type); !names.empty())
      text += fmt::format("; one of {}", fmt::join(names, ", "));
    text += "\n";
  }
  return text;
}

constexpr std::string_view introduction = R"(# Reference: specs, and fields of a row

A spec is a TOML file of these tables. Units are SI.

)";
constexpr std::string_view forms_of_values =
    R"(Each parameter is a value, or an axis if it has several: a list, `[1, 2, 5]`; a range,
`{ from = 0.01, to = 10, count = 61, scale = "log" }`; or a sample,
`{ sample = "sobol", from = 0.01, to = 10, count = 64, scale = "log", seed = 1 }`. A number may also be an expression of
other parameters, `s0 = "0.01*d"`, which has its value in each tuple. Axes multiply, the last one fastest, unless `zip`,
`points` or `sample` make them advance together.

    [sweep]                                     # a sample of two parameters together, and five seeds for each point
    epsilon = { sample = "normal", mean = 0.9, sd = 0.02, to = 1 }
    sigma   = { from = 0.01, to = 10, scale = "log" }
    sample  = { method = "sobol", of = ["epsilon", "sigma"], count = 64 }
    seed    = [1, 2, 3, 4, 5]

    [defaults]                                  # keys of each [[sweep]] that does not have them itself
    N = 10
    [[sweep]]                                   # the rows of one after those of the other
    method = "md"
    points = "measured.csv"                     # a line "v0,tc,s0,epsilon", then a line for each tuple
    [[sweep]]
    method = "ed"

The keys of a range and of a sample:

)";
constexpr std::string_view what_is_needed = R"(
These must be given: `v0`, `N` (of a lattice `rows`), and `s0` or `sigma`. A vibrated column needs `alpha` or `A0`, no
gap, and `v0` for laws that are not linear only. Stiffness and damping are given by `tc` and `epsilon`, by `K_over_m`
and `D_n`, or by a `material`. The law `"power"` needs `beta` and `gamma`. An integrator of fixed step takes
`steps_per_tc` or a `tolerance`. The parameters are listed [below](#fields-of-a-row); beside them [sweep] has:

)";
constexpr std::string_view laws_of_contact = R"(
Laws of contact, F = K x^(1+beta) + D x^gamma x':

)";
constexpr std::string_view expressions = R"(## Expressions and conditions

An expression is made of names of fields, numbers, the operators `+ - * / ^`, `== != < <= > >=`, `&& || !` and `?:`, and
the functions of muParser: abs, sqrt, exp, ln, log10, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, min, max, sum,
avg, sign, rint. A condition is true or false, such as `sigma > 1e-4 && (method == md || N <= 10)`. An enumeration
is compared with its own names. Conditions in [sweep] and [trajectory] are over parameters, the others over all fields.
The `y` of a guide is a function of `x`.

)";

std::string section_of(const KeyInfo& table) {
  if (table.form == KeyForm::text)
    return fmt::format("`{}` ({}): {}\n\n", table.name, name_of(table.form), table.meaning);
  if (table.name == "plot") return plot_reference() + "\n";
  if (table.name == "defaults")
    return fmt::format("## [defaults]: {}\n\nThe keys are those of [sweep].\n\n", table.meaning);
  if (table.name != "sweep")
    return fmt::format("## [{}]: {}\n\n{}\n", table.name, table.meaning, lines_of(table.keys()));
  return fmt::format("## [sweep]: {}\n\n{}{}{}{}{}{}\n", table.meaning, forms_of_values, lines_of(spec::keys_of_axis()),
                     what_is_needed, lines_of(table.keys()), laws_of_contact, lines_of_laws());
}

}  // namespace

std::string plot_reference() { return "## [plot], or several [[plot]]\n\n" + lines_of(spec::keys_of_plot()); }

std::string field_reference() {
  return fmt::format("## Fields of a row\n\nParameters:\n\n{}\nResults:\n\n{}\nTimings:\n\n{}", lines_of_parameters(),
                     lines_of(result_fields()), lines_of(timing_fields()));
}

std::string spec_reference(std::span<const SpecSection> sections) {
  std::string text(introduction);
  for (const KeyInfo& table : spec::keys_of_spec(sections)) text += section_of(table);
  return text + std::string(expressions) + field_reference();
}

}  // namespace sigmasweep
