#include "sweep/spec/tuples/dependent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sigmasweep/base/errors.hpp"
#include "sweep/expression/expression.hpp"
#include "sweep/spec/tuples/base.hpp"
#include "sweep/spec/tuples/check.hpp"

namespace sigmasweep::spec {
namespace {

/// Largest number of tuples for which an expression is checked; about a second.
constexpr std::uint64_t max_checked = std::uint64_t{1} << 21;

bool depends(const Setting& setting) { return !setting.expression.empty(); }

using Causes = std::vector<ParameterField>;

Causes causes_of(const Setting& setting, const std::vector<Setting>& settings) {
  Causes causes =
      Expression<Parameters>(setting.expression, fields_of_parameters(), expression_types::Wanted::number).used();
  for (const ParameterField& cause : causes) {
    if (cause.name == "d" && find(settings, "material")) refuse_value(setting.entry, "d follows from the material");
    if (!find(settings, cause.name) && !has_default(cause))
      refuse_value(setting.entry, fmt::format("{} is not given, and has no default", cause.name));
  }
  return causes;
}

/// Visits the parameters on which a parameter depends before itself.
class Order {
 public:
  explicit Order(std::vector<Setting>& settings) : settings_(settings) {}

  std::vector<Setting*> all() {
    for (Setting& setting : settings_)
      if (depends(setting)) visit(setting);
    return done_;
  }

 private:
  void visit(Setting& setting) {
    if (std::ranges::find(done_, &setting) != done_.end()) return;
    path_.push_back(setting.field->name);
    if (std::ranges::count(path_, setting.field->name) > 1)
      refuse_value(setting.entry, fmt::format("a circle: {}", fmt::join(path_, " -> ")));
    for (const ParameterField& cause : causes_of(setting, settings_))
      for (Setting& other : settings_)
        if (other.field->name == cause.name && depends(other)) visit(other);
    path_.pop_back();
    done_.push_back(&setting);
  }

  std::vector<Setting>& settings_;
  std::vector<Setting*> done_;
  std::vector<std::string_view> path_;
};

/// The groups with axes on which an expression depends, directly or through earlier dependents.
std::vector<ParameterGrid::Group> groups_behind(const Expression<Parameters>& expression, const Dependents& earlier,
                                                const std::vector<ParameterGrid::Group>& groups) {
  std::vector<std::string_view> used;
  for (const ParameterField& field : expression.used()) used.push_back(field.name);
  return groups_with(groups, earlier.with_causes(used));
}

std::string why_bad(const ParameterField& field, double value) {
  if (!std::isfinite(value)) return "it must be a finite number";
  if (field.type == FieldType::integer && std::round(value) != value) return "it must be a whole number";
  if (field.allowed.contain && !field.allowed.contain(value))
    return fmt::format("it must be {}", field.allowed.must_be);
  return {};
}

/// The values of the axes at an index, such as " where d = 0.001, N = 10".
std::string where(const std::vector<ParameterGrid::Group>& groups, const Parameters& tuple) {
  std::vector<std::string> values;
  for (const ParameterGrid::Group& group : groups)
    for (const ParameterGrid::Member& member : group)
      values.push_back(fmt::format("{} = {}", member.field->name, text(*member.field, tuple)));
  return values.empty() ? "" : fmt::format(" where {}", fmt::join(values, ", "));
}

/// The least and the largest value of an expression over all tuples.
Axis checked(const Setting& setting, const Parameters& base, const Dependents& earlier,
             const std::vector<ParameterGrid::Group>& groups) {
  Expression<Parameters> expression(setting.expression, fields_of_parameters(), expression_types::Wanted::number);
  const auto behind = groups_behind(expression, earlier, groups);
  if (const double count = count_of(behind); count > static_cast<double>(max_checked))
    refuse_value(setting.entry,
                 fmt::format("depends on axes with {:.3g} combinations, at most {} are allowed", count, max_checked));
  std::optional<double> least, most;
  for (std::uint64_t i = 0; i < size_of(behind); ++i) {
    Parameters tuple = values_at(base, behind, i);
    earlier.set(tuple);
    const double value = expression(tuple);
    if (const std::string why = why_bad(*setting.field, value); !why.empty())
      refuse_value(setting.entry, fmt::format("is {}{}, but {}", value, where(behind, tuple), why));
    least = std::min(value, least.value_or(value));
    most = std::max(value, most.value_or(value));
  }
  return Axis::list(*least == *most ? std::vector<AnyNumber>{*least} : std::vector<AnyNumber>{*least, *most});
}

}  // namespace

Dependents read_dependents(std::vector<Setting>& settings, const std::vector<ParameterGrid::Group>& groups) {
  Dependents dependents;
  for (Setting* setting : Order(settings).all()) {
    setting->axis = checked(*setting, base_of(settings), dependents, groups);
    dependents.add(*setting->field, setting->expression);
  }
  return dependents;
}

}  // namespace sigmasweep::spec
