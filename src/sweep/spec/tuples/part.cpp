#include "sweep/spec/tuples/part.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/fields/conditions.hpp"
#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/calibration_cache.hpp"
#include "sweep/expression/where.hpp"
#include "sweep/spec/tuples/base.hpp"
#include "sweep/spec/tuples/check.hpp"
#include "sweep/spec/tuples/contents.hpp"
#include "sweep/spec/tuples/dependent.hpp"
#include "sweep/spec/tuples/representatives.hpp"
#include "sweep/spec/tuples/values.hpp"
#include "sweep/spec/tuples/zips.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::uint64_t max_tuples = std::uint64_t{1} << 40;

/// Largest number of tuples that `where` selects from. A short expression takes about ten seconds for all of them.
constexpr std::uint64_t max_filtered = std::uint64_t{1} << 26;
constexpr std::size_t short_expression = 64;  // characters
/// Largest number of tuples that `where` selects from if each takes 0.1 ms.
constexpr std::uint64_t max_filtered_slowly = std::uint64_t{1} << 17;

void require_countable(const Entry& sweep, const std::vector<ParameterGrid::Group>& groups) {
  const double tuples = count_of(groups);
  if (tuples > static_cast<double>(max_tuples))
    refuse(sweep, fmt::format("the axes multiply to {:.{}} tuples, at most 2^40 = {} are allowed", tuples,
                              tuples < 1e15 ? 16 : 3, max_tuples));
}

Selection select(const Entry& entry, const std::vector<Setting>& settings, const ParameterGrid& product) {
  ParameterWhere where = condition_of(entry);
  const std::size_t length = as_string(entry).size();
  const std::uint64_t most = product.contacts().is_slow()
                                 ? max_filtered_slowly
                                 : max_filtered * short_expression / std::max(short_expression, length);
  if (product.size() > most)
    refuse(entry, fmt::format("the axes multiply to {} tuples, with a 'where' of this length at most {} are allowed",
                              product.size(), most));
  Selection selection;
  for (std::uint64_t i = 0; i < product.size(); ++i) {
    const Parameters tuple = product.at(i);
    const bool chosen = where(tuple);
    if (chosen) require_soft_lattice(settings, tuple);
    if (chosen && conditions::lattice.holds(tuple))
      if (const std::string why = why_invalid(tuple); !why.empty()) refuse_value(entry, why);
    selection.push(chosen);
  }
  if (selection.size() == 0) refuse_value(entry, "no tuple satisfies it");
  return selection;
}

/// The settings taken together.
struct Combined {
  std::vector<ParameterGrid::Group> groups;
  Dependents dependents;
  Parameters base;
  std::vector<Parameters> tuples;  ///< representative ones
};

Combined combine(SweepKeys& contents) {
  auto& [settings, zips, zip, where] = contents;
  if (zip) require_zippable(*zip, zips, settings);
  Combined all;
  all.groups = groups_of(settings, zips);
  all.dependents = read_dependents(settings, all.groups);
  all.base = base_of(settings);
  all.tuples = representative_tuples(all.base, all.groups, all.dependents);
  return all;
}

/// Leaves out the keys of [defaults] that no tuple of this part uses. Returns whether there are any.
bool leave_out_unused_defaults(SweepKeys& contents, const std::vector<Parameters>& tuples) {
  auto& [settings, zips, zip, where] = contents;
  const auto is_left_out = [&](const Setting& setting) {
    return is_default(setting.entry) &&
           std::ranges::none_of(tuples, [&](const Parameters& tuple) { return applies_to(*setting.field, tuple); });
  };
  for (Zip& names : zips)
    std::erase_if(names, [&](const std::string& name) {
      const Setting* setting = find(settings, name);
      return setting != nullptr && is_left_out(*setting);
    });
  std::erase_if(zips, [](const Zip& names) { return names.size() < 2; });
  return std::erase_if(settings, is_left_out) > 0;
}

/// Checks the settings together. A check that relies on others comes after these.
void require_consistent(const Entry& sweep, const SweepKeys& contents, const Combined& all) {
  const auto& [settings, zips, zip, where] = contents;
  const auto& [groups, dependents, base, tuples] = all;
  if (!where)
    for (const Parameters& tuple : tuples) require_soft_lattice(settings, tuple);
  require_one_way(settings);
  require_complete(sweep, settings, tuples);
  require_used(settings, tuples);
  Mistakes mistakes;
  mistakes.keep([&] { require_diameters(settings, zips, base); });
  mistakes.keep([&] { require_lattice(settings, zips, base); });
  mistakes.keep([&] { require_plate(settings, zips, base); });
  const bool of_lattice = !where && std::ranges::any_of(tuples, conditions::lattice.holds);
  mistakes.keep([&] { require_finite_gap(settings, base, of_lattice); });
  mistakes.keep([&] { require_countable(sweep, groups); });
  mistakes.refuse_any();
}

}  // namespace

std::optional<Grid> read_part(const Entry& sweep, const std::vector<Entry>& defaults, bool keys_alone) {
  SweepKeys contents = read_contents(sweep, defaults);
  if (keys_alone) return std::nullopt;
  Combined all = combine(contents);
  if (leave_out_unused_defaults(contents, all.tuples)) all = combine(contents);
  require_consistent(sweep, contents, all);
  const auto& settings = contents.settings;
  const GapParameter gap = find(settings, "sigma") ? GapParameter::sigma : GapParameter::s0;
  Grid grid{ParameterGrid(all.base, gap, std::move(all.groups), std::move(all.dependents)), {}, {}, {}, all.tuples, {}};
  require_pairs(settings, grid.product);
  for (const Setting& setting : settings) {
    grid.given.push_back(setting.field);
    if (!setting.is_axis) continue;
    grid.axes.push_back(setting.field);
    grid.axis_sizes.push_back(setting.axis.size());
  }
  if (contents.where) grid.selection = select(*contents.where, settings, grid.product);
  return grid;
}

std::uint64_t size_of(const Grid& grid) { return grid.selection ? grid.selection->size() : grid.product.size(); }

}  // namespace sigmasweep::spec
