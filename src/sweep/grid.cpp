#include "sweep/grid.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "sigmasweep/assembly/complete.hpp"
#include "sweep/calibration_cache.hpp"

namespace sigmasweep {

double count_of(const std::vector<ParameterGrid::Group>& groups) {
  double count = 1.0;
  for (const ParameterGrid::Group& group : groups) count *= static_cast<double>(group.front().axis.size());
  return count;
}

std::vector<ParameterGrid::Group> groups_with(const std::vector<ParameterGrid::Group>& groups,
                                              std::span<const std::string_view> names) {
  const auto is_named = [&](const ParameterGrid::Member& member) {
    return std::ranges::find(names, member.field->name) != names.end();
  };
  std::vector<ParameterGrid::Group> found;
  std::ranges::copy_if(groups, std::back_inserter(found),
                       [&](const auto& group) { return std::ranges::any_of(group, is_named); });
  return found;
}

std::uint64_t size_of(const std::vector<ParameterGrid::Group>& groups) {
  std::uint64_t size = 1;
  for (const ParameterGrid::Group& group : groups) size *= group.front().axis.size();
  return size;
}

Parameters values_at(const Parameters& base, const std::vector<ParameterGrid::Group>& groups, std::uint64_t index) {
  Parameters values = base;
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    const std::uint64_t length = group->front().axis.size();
    for (const ParameterGrid::Member& member : *group)
      set_exact_number(*member.field, values, member.axis[index % length]);
    index /= length;
  }
  return values;
}

ParameterGrid::ParameterGrid(const Parameters& base, GapParameter gap, std::vector<Group> groups, Dependents dependents)
    : base_(base),
      gap_(gap),
      groups_(std::move(groups)),
      dependents_(std::move(dependents)),
      size_(size_of(groups_)),
      contacts_(std::make_shared<const CalibrationCache>(base_, groups_, dependents_)) {}

Parameters ParameterGrid::at(std::uint64_t index) const {
  assert(index < size_);
  Parameters parameters = values_at(base_, groups_, index);
  dependents_.set(parameters);
  derive_beads(parameters);
  contacts_->derive_contact(parameters);
  derive_gap(parameters, gap_);
  derive_plate_motion(parameters);
  return parameters;
}

}  // namespace sigmasweep
