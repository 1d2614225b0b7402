#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sweep/axis.hpp"
#include "sweep/dependents.hpp"

namespace sigmasweep {

class CalibrationCache;

/// All tuples of a sweep before `where`. Groups of axes multiply, the last group fastest; the axes of one group advance
/// together. A tuple is computed from its index.
class ParameterGrid {
 public:
  struct Member {
    const ParameterField* field;
    Axis axis;
  };
  using Group = std::vector<Member>;  ///< one or more axes of equal length

  /// `base` has the parameters that are neither axes nor dependents; `gap` is the one of s0 and sigma that is given.
  /// Fills a CalibrationCache.
  ParameterGrid(const Parameters& base, GapParameter gap, std::vector<Group> groups, Dependents dependents);

  std::uint64_t size() const { return size_; }
  /// The tuple with the parameters that complete() derives. Several threads may call it at once.
  Parameters at(std::uint64_t index) const;
  const Parameters& base() const { return base_; }
  const std::vector<Group>& groups() const { return groups_; }
  const Dependents& dependents() const { return dependents_; }
  const CalibrationCache& contacts() const { return *contacts_; }

 private:
  Parameters base_;
  GapParameter gap_;
  std::vector<Group> groups_;
  Dependents dependents_;
  std::uint64_t size_ = 1;
  std::shared_ptr<const CalibrationCache> contacts_;
};

/// Number of tuples of the groups, counted in floating point, which does not overflow.
double count_of(const std::vector<ParameterGrid::Group>& groups);
/// The groups that have an axis of one of these names.
std::vector<ParameterGrid::Group> groups_with(const std::vector<ParameterGrid::Group>& groups,
                                              std::span<const std::string_view> names);
/// The same number where it fits into 64 bits.
std::uint64_t size_of(const std::vector<ParameterGrid::Group>& groups);
/// The parameters `base` with the values of the groups' axes at an index.
Parameters values_at(const Parameters& base, const std::vector<ParameterGrid::Group>& groups, std::uint64_t index);

}  // namespace sigmasweep
