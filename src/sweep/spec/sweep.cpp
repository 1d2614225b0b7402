#include "sweep/spec/sweep.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sweep/calibration_cache.hpp"
#include "sweep/expression/where.hpp"
#include "sweep/spec/check.hpp"
#include "sweep/spec/representatives.hpp"
#include "sweep/spec/values.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::uint64_t max_tuples = std::uint64_t{1} << 40;

/// Largest number of tuples that `where` selects from. A short expression takes about ten seconds for all of them.
constexpr std::uint64_t max_filtered = std::uint64_t{1} << 26;
constexpr std::size_t short_expression = 64;  // characters
/// Largest number of tuples that `where` selects from if each takes 0.1 ms.
constexpr std::uint64_t max_filtered_slowly = std::uint64_t{1} << 17;

/// Keys of [sweep] that are not parameters.
constexpr auto other_keys = std::to_array<KeyInfo>({
    {"zip", KeyForm::groups, "groups of axes that advance together", "all axes multiply"},
    {"where", KeyForm::condition, "condition on the parameters of the tuples that are computed", "all tuples"},
});

void require_known(const Entry& key) {
  std::vector<std::string_view> known;
  for (const Field& field : parameter_fields()) known.push_back(field.name);
  for (const KeyInfo& other : other_keys) known.push_back(other.name);
  if (std::find(known.begin(), known.end(), key.name) == known.end()) refuse_unknown(key, known);
}

std::vector<Zip> read_zips(const Entry& entry) {
  std::vector<Zip> zips;
  for (const Entry& group : elements(entry)) {
    if (!group.node->is_array()) refuse_value(group, "must be a list of groups, such as [[\"v0\", \"tc\"]]");
    Zip zip;
    for (const Entry& element : elements(group)) {
      const std::string name = as_string(element);
      if (zip_of(zips, name) || std::find(zip.begin(), zip.end(), name) != zip.end())
        refuse_value(element, "is zipped already");
      zip.push_back(name);
    }
    if (zip.size() < 2) refuse(group, "a group needs at least two axes");
    zips.push_back(std::move(zip));
  }
  return zips;
}

/// The parameters among the keys. Keeps the mistakes of all keys that are neither zip nor where.
std::vector<Setting> read_settings(const std::vector<Entry>& keys, const std::vector<Zip>& zips, Mistakes& mistakes) {
  std::vector<Setting> settings;
  std::map<const Zip*, std::size_t> sobol_axes;  // zipped Sobol axes are dimensions of one sequence
  const auto read = [&](const Entry& key) {
    require_known(key);
    const ParameterField* field = find_parameter(key.name);
    if (field == nullptr) return;
    const Zip* zip = zip_of(zips, key.name);
    settings.push_back(read_setting(key, *field, zip ? sobol_axes[zip] : 0));
    if (settings.back().is_sobol) ++sobol_axes[zip];
  };
  for (const Entry& key : keys) mistakes.keep([&] { read(key); });
  return settings;
}

void require_zippable(const Entry& entry, const std::vector<Zip>& zips, const std::vector<Setting>& settings) {
  std::vector<std::string_view> axes;
  for (const Setting& setting : settings)
    if (setting.is_axis) axes.push_back(setting.field->name);
  for (const Zip& zip : zips) {
    for (const std::string& name : zip)
      if (std::find(axes.begin(), axes.end(), name) == axes.end())
        refuse(entry, fmt::format("'{}' is not an axis; axes: {}", name, fmt::join(axes, ", ")));
    const std::uint64_t length = find(settings, zip.front())->axis.size();
    for (const std::string& name : zip)
      if (const std::uint64_t other = find(settings, name)->axis.size(); other != length)
        refuse(entry, fmt::format("zipped axes must be of equal length: '{}' has {} values, '{}' has {}", zip.front(),
                                  length, name, other));
  }
}

/// Groups of axes in spec order; the place of a zip is that of its first axis.
std::vector<ParameterGrid::Group> groups_of(const std::vector<Setting>& settings, const std::vector<Zip>& zips) {
  std::vector<ParameterGrid::Group> groups;
  std::map<const Zip*, std::size_t> group_of;
  for (const Setting& setting : settings) {
    if (!setting.is_axis) continue;
    const Zip* zip = zip_of(zips, setting.field->name);
    const bool begins = zip == nullptr || group_of.emplace(zip, groups.size()).second;
    ParameterGrid::Group& group = begins ? groups.emplace_back() : groups[group_of.at(zip)];
    group.push_back({setting.field, setting.axis});
  }
  return groups;
}

void require_countable(const Entry& sweep, const std::vector<ParameterGrid::Group>& groups) {
  double tuples = 1.0;
  for (const ParameterGrid::Group& group : groups) tuples *= static_cast<double>(group.front().axis.size());
  if (tuples > static_cast<double>(max_tuples))
    refuse(sweep, fmt::format("the axes multiply to {:.{}} tuples, at most 2^40 = {} are allowed", tuples,
                              tuples < 1e15 ? 16 : 3, max_tuples));
}

Parameters base_of(const std::vector<Setting>& settings) {
  Parameters base;
  const Setting* integrator = find(settings, "integrator");
  if (integrator && integrator->axis.bounds().second > 0.0 && find(settings, "tolerance"))
    base.steps_per_tc = 0.0;  // the step is chosen for the tolerance, unless steps_per_tc is given
  static_assert(static_cast<int>(Integrator::exact) == 0);
  for (const Setting& setting : settings) set_exact_number(*setting.field, base, setting.axis[0]);
  return base;
}

ParameterWhere condition_of(const Entry& entry) {
  try {
    return {as_string(entry), fields_of_parameters()};
  } catch (const UsageError& error) {
    refuse_value(entry, error.what());
  }
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
    selection.push(chosen);
  }
  if (selection.size() == 0) refuse_value(entry, "no tuple satisfies it");
  return selection;
}

/// What [sweep] has, each key read by itself.
struct Contents {
  std::vector<Setting> settings;
  std::vector<Zip> zips;
  std::optional<Entry> zip, where;
};

Contents read_contents(const std::vector<Entry>& keys) {
  Contents contents;
  for (const Entry& key : keys) {
    if (key.name == "zip") contents.zip = key;
    if (key.name == "where") contents.where = key;
  }
  Mistakes mistakes;
  if (contents.zip) mistakes.keep([&] { contents.zips = read_zips(*contents.zip); });
  contents.settings = read_settings(keys, contents.zips, mistakes);
  if (contents.where) mistakes.keep([&] { condition_of(*contents.where); });
  mistakes.refuse_any();
  return contents;
}

/// Checks the settings together. A check that relies on others comes after these.
void require_consistent(const Entry& sweep, const Contents& contents, const Parameters& base,
                        const std::vector<ParameterGrid::Group>& groups, const std::vector<Parameters>& tuples) {
  const auto& [settings, zips, zip, where] = contents;
  if (!where)
    for (const Parameters& tuple : tuples) require_soft_lattice(settings, tuple);
  require_one_way(settings);
  require_complete(sweep, settings, tuples);
  require_used(settings, tuples);
  Mistakes mistakes;
  mistakes.keep([&] { require_diameters(settings, zips, base); });
  mistakes.keep([&] { require_lattice(settings, zips, base); });
  mistakes.keep([&] { require_plate(settings, zips, base); });
  mistakes.keep([&] { require_finite_gap(settings, base); });
  mistakes.keep([&] { require_countable(sweep, groups); });
  mistakes.refuse_any();
}

}  // namespace

std::optional<Grid> read_sweep(const Entry& sweep, bool keys_alone) {
  const auto keys = entries(as_table(sweep), *sweep.file, sweep.path);
  const Contents contents = read_contents(keys);
  if (keys_alone) return std::nullopt;
  const auto& [settings, zips, zip, where] = contents;
  if (zip) require_zippable(*zip, zips, settings);
  const Parameters base = base_of(settings);
  auto groups = groups_of(settings, zips);
  const std::vector<Parameters> tuples = representative_tuples(base, groups);
  require_consistent(sweep, contents, base, groups, tuples);
  Grid grid{ParameterGrid(base, find(settings, "sigma") ? GapParameter::sigma : GapParameter::s0, std::move(groups)),
            {},
            {},
            {},
            tuples,
            {}};
  require_pairs(settings, grid.product);
  for (const Setting& setting : settings) {
    grid.given.push_back(setting.field);
    if (!setting.is_axis) continue;
    grid.axes.push_back(setting.field);
    grid.axis_sizes.push_back(setting.axis.size());
  }
  if (where) grid.selection = select(*where, settings, grid.product);
  return grid;
}

std::vector<KeyInfo> keys_of_sweep() { return {other_keys.begin(), other_keys.end()}; }

}  // namespace sigmasweep::spec
