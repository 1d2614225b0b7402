#include "sweep/spec/tuples/zips.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sigmasweep::spec {

void read_zips(const Entry& entry, std::vector<Zip>& zips) {
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

}  // namespace sigmasweep::spec
