#include "python/given.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/exact_number.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::python {
namespace {

template <class Number>
AnyNumber at(std::span<const Number> values, std::size_t k) {
  return values.size() == 1 ? values[0] : values[k];
}

AnyNumber value(const Given& given, std::size_t k) {
  return std::visit([k](const auto& values) { return at(values, k); }, given.values);
}

bool varies(const Given& given) {
  return std::visit([](const auto& values) { return values.size() > 1; }, given.values);
}

/// The value in TOML.
std::string toml_value(const Given& given, std::size_t k) {
  const FieldType& type = given.field->type;
  const AnyNumber number = value(given, k);
  const auto names = enumerators(type);
  if (names.empty())
    return type == FieldType::real ? fmt::format("{}", static_cast<double>(number)) : fmt::format("{:.0f}", number);
  const std::string_view name = names[static_cast<std::size_t>(number)];
  return type == FieldType::of<Flag>() ? std::string(name) : fmt::format("\"{}\"", name);
}

std::vector<std::size_t> representative_tuples(std::span<const Given> given, std::size_t count) {
  std::set<std::vector<int>> known;
  std::vector<std::size_t> chosen;
  std::vector<int> pattern(given.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      const AnyNumber number = value(given[i], k);
      pattern[i] = enumerators(given[i].field->type).empty() ? number != 0 : static_cast<int>(number);
    }
    if (known.insert(pattern).second) chosen.push_back(k);
  }
  return chosen;
}

}  // namespace

bool is_given(std::span<const Given> given, std::string_view name) {
  return std::ranges::any_of(given, [&](const Given& one) { return one.field->name == name; });
}

Parameters tuple_of(std::span<const Given> given, std::size_t k) {
  Parameters p;
  for (const Given& one : given) set_exact_number(*one.field, p, value(one, k));
  // The step of an integrator of fixed step is chosen for a tolerance, unless it is given.
  if (p.integrator != Integrator::exact && is_given(given, "tolerance") && !is_given(given, "steps_per_tc"))
    p.steps_per_tc = 0.0;
  return p;
}

Sweep representatives(std::span<const Given> given, std::size_t count) {
  const std::vector<std::size_t> chosen = representative_tuples(given, count);
  std::string text = "[sweep]\n";
  std::vector<std::string_view> axes;
  for (const Given& one : given) {
    std::vector<std::string> values;
    for (const std::size_t k : chosen) values.push_back(toml_value(one, k));
    if (varies(one)) axes.push_back(one.field->name);
    text += varies(one) ? fmt::format("{} = [{}]\n", one.field->name, fmt::join(values, ", "))
                        : fmt::format("{} = {}\n", one.field->name, values[0]);
  }
  if (axes.size() > 1) text += fmt::format("zip = [[\"{}\"]]\n", fmt::join(axes, "\", \""));
  const std::string file = "simulate";
  try {
    return Sweep::parse(text, file);
  } catch (const SpecError& error) {
    throw SpecError(spec::without_places(error.what(), file));
  }
}

}  // namespace sigmasweep::python
