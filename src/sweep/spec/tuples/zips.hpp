#pragma once

#include <string_view>
#include <vector>

#include "sweep/grid.hpp"
#include "sweep/spec/tuples/axis.hpp"
#include "sweep/spec/tuples/check.hpp"

/// Axes that advance together: the key zip, joint samples, and lists of points. All throw SpecError.
namespace sigmasweep::spec {

/// Adds the groups of the key zip. An axis can be in one group only.
void read_zips(const Entry& zip, std::vector<Zip>& zips);
/// Requires that all members are axes, of equal length in a group.
void require_zippable(const Entry& zip, const std::vector<Zip>& zips, const std::vector<Setting>& settings);
/// Groups of axes in spec order; the place of a zip is that of its first axis.
std::vector<ParameterGrid::Group> groups_of(const std::vector<Setting>& settings, const std::vector<Zip>& zips);

}  // namespace sigmasweep::spec
