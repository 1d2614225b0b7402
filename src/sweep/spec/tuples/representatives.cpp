#include "sweep/spec/tuples/representatives.hpp"

#include <algorithm>
#include <set>

namespace sigmasweep::spec {
namespace {

bool is_enumeration(const ParameterGrid::Member& member) { return !enumerators(member.field->type).empty(); }

using Values = std::vector<AnyNumber>;  ///< a value for each member of a group

/// Values of a group: with enumerations all different ones, other numbers as 0 or 1; else the largest of each member.
std::set<Values> representative_values(const ParameterGrid::Group& group) {
  std::set<Values> distinct;
  if (std::ranges::none_of(group, is_enumeration)) {
    Values largest;
    for (const ParameterGrid::Member& member : group) largest.push_back(member.axis.bounds().second);
    distinct.insert(std::move(largest));
    return distinct;
  }
  for (std::uint64_t k = 0; k < group.front().axis.size(); ++k) {
    Values values;
    for (const ParameterGrid::Member& member : group)
      values.push_back(is_enumeration(member) || member.axis[k] <= 0 ? member.axis[k] : 1);
    distinct.insert(std::move(values));
  }
  return distinct;
}

}  // namespace

std::vector<Parameters> representative_tuples(const Parameters& base, const std::vector<ParameterGrid::Group>& groups,
                                              const Dependents& dependents) {
  std::vector<Parameters> tuples{base};
  for (const ParameterGrid::Group& group : groups) {
    std::vector<Parameters> more;
    for (const Values& values : representative_values(group))
      for (const Parameters& tuple : tuples) {
        more.push_back(tuple);
        for (std::size_t i = 0; i < group.size(); ++i) set_exact_number(*group[i].field, more.back(), values[i]);
      }
    tuples = std::move(more);
  }
  for (Parameters& tuple : tuples) dependents.set(tuple);
  return tuples;
}

}  // namespace sigmasweep::spec
