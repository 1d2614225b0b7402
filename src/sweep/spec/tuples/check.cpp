#include "sweep/spec/tuples/check.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/fields/conditions.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

/// Parameters that are given together.
using Way = std::array<std::string_view, 2>;
constexpr Way by_contact{"tc", "epsilon"}, by_spring{"K_over_m", "D_n"}, by_material{"material", ""};

const Setting* first_of(const Way& way, const std::vector<Setting>& settings) {
  for (const std::string_view name : way)
    if (const Setting* setting = find(settings, name)) return setting;
  return nullptr;
}

[[noreturn]] void refuse_missing(const Entry& sweep, const std::vector<std::string_view>& names,
                                 const std::vector<Parameters>& tuples) {
  const bool vibrated = std::ranges::all_of(tuples, conditions::vibrates.holds),
             any_lattice = std::ranges::any_of(tuples, conditions::lattice.holds);
  const std::string_view size = std::ranges::all_of(tuples, conditions::lattice.holds) ? "rows"
                                : any_lattice                                          ? "N, rows"
                                                                                       : "N";
  refuse(sweep, fmt::format("'{}' {} missing: {}{}, one of {}, and tc and epsilon (or instead of these K_over_m and "
                            "D_n, or a material) are needed",
                            fmt::join(names, "', '"), names.size() == 1 ? "is" : "are", vibrated ? "" : "v0, ", size,
                            vibrated ? "alpha and A0" : "s0 and sigma"));
}

/// Whether tc must be given. Collisions of hard spheres take no time; the default tc only gives sigma its unit.
bool needs_tc(const Parameters& tuple) { return tuple.method == Method::md || tuple.ed_rule == EdRule::tc; }

/// Requires at most one of two parameters that determine each other, and exactly one if `needed`.
void require_one_of(const Entry& sweep, const std::vector<Setting>& settings, const Way& names, bool needed,
                    std::string_view relation) {
  const Setting *one = find(settings, names[0]), *other = find(settings, names[1]);
  if (!one && !other && needed) refuse(sweep, fmt::format("one of '{}' and '{}' is missing", names[0], names[1]));
  if (one && other)
    refuse((one->entry.line > other->entry.line ? one : other)->entry,
           fmt::format("give {} or {}, not both: {}", names[0], names[1], relation));
}

}  // namespace

const Setting* find(const std::vector<Setting>& settings, std::string_view name) {
  for (const Setting& setting : settings)
    if (setting.field->name == name) return &setting;
  return nullptr;
}

const Zip* zip_of(const std::vector<Zip>& zips, std::string_view name) {
  for (const Zip& zip : zips)
    if (std::find(zip.begin(), zip.end(), name) != zip.end()) return &zip;
  return nullptr;
}

void require_one_way(const std::vector<Setting>& settings) {
  const Setting* first = nullptr;
  for (const Way& way : {by_contact, by_spring, by_material}) {
    const Setting* given = first_of(way, settings);
    if (first && given)
      refuse((first->entry.line > given->entry.line ? first : given)->entry,
             fmt::format("'{}' and '{}' conflict: give tc and epsilon, or K_over_m and D_n, or a material",
                         first->field->name, given->field->name));
    if (given) first = given;
  }
  if (const Setting* K_over_m = find(settings, "K_over_m"); K_over_m && !(K_over_m->axis.bounds().first > 0.0))
    refuse(K_over_m->entry, "must be > 0");
  if (const Setting* steps = find(settings, "steps_per_tc"); steps && !(steps->axis.bounds().first > 0.0))
    refuse(steps->entry, "must be from 2 to 1e6; without it the step is chosen for a tolerance");
  const Setting* material = find(settings, "material");
  if (!material) return;
  if (material->axis.bounds().first == static_cast<double>(Material::none))
    refuse(material->entry, "'none' is the default: leave the material out");
  if (const Setting* d = find(settings, "d")) refuse(d->entry, "'d' and 'material' conflict: d is the material's");
}

void require_complete(const Entry& sweep, const std::vector<Setting>& settings, const std::vector<Parameters>& tuples) {
  const bool all_vibrated = std::ranges::all_of(tuples, conditions::vibrates.holds);
  std::vector<std::string_view> missing;
  const auto require = [&](std::string_view name) {
    if (!find(settings, name)) missing.push_back(name);
  };
  const auto require_where_used = [&](std::string_view name) {
    const Field& field = *find_field(name);
    if (std::ranges::any_of(tuples, [&](const Parameters& tuple) { return applies_to(field, tuple); })) require(name);
  };
  require_where_used("v0");
  if (first_of(by_spring, settings)) {
    require("K_over_m");
  } else if (!first_of(by_material, settings)) {
    if (std::ranges::any_of(tuples, needs_tc)) require("tc");
    require("epsilon");
  }
  require_where_used("N");
  require_where_used("rows");
  if (!missing.empty()) refuse_missing(sweep, missing, tuples);
  require_one_of(sweep, settings, {"s0", "sigma"}, !all_vibrated, "sigma = s0/(v0 tc)");
  require_one_of(sweep, settings, {"alpha", "A0"}, std::ranges::any_of(tuples, conditions::vibrates.holds),
                 "alpha = A0 (2 pi frequency)^2/gravity");
  for (const std::string_view name : {"beta", "gamma"})
    if (!find(settings, name) &&
        std::ranges::any_of(tuples, [&](const Parameters& tuple) { return applies_to(*find_field(name), tuple); }))
      refuse(find(settings, "law")->entry, fmt::format("'{}' is missing: law = 'power' needs beta and gamma", name));
}

void require_soft_lattice(const std::vector<Setting>& settings, const Parameters& tuple) {
  if (conditions::lattice.holds(tuple) && tuple.method == Method::ed)
    refuse(find(settings, "method")->entry, "hard spheres, 'ed', are for columns only: a lattice needs method = 'md'");
}

void require_used(const std::vector<Setting>& settings, const std::vector<Parameters>& tuples) {
  const auto used = [&](const Setting& setting) {
    return std::ranges::any_of(tuples, [&](const Parameters& tuple) { return applies_to(*setting.field, tuple); });
  };
  Mistakes mistakes;
  const auto require = [&](const Setting& setting) {
    if (used(setting)) return;
    const Setting* steps = find(settings, "steps_per_tc");
    if (setting.field->name == "tolerance" && steps && used(*steps))
      refuse(setting.entry,
             "'steps_per_tc' and 'tolerance' conflict: give the time step, or the error for which it "
             "is chosen");
    refuse(setting.entry, fmt::format("no tuple uses it: it needs {}", requirement_of(*setting.field)));
  };
  for (const Setting& setting : settings) mistakes.keep([&] { require(setting); });
  mistakes.refuse_any();
}

}  // namespace sigmasweep::spec
