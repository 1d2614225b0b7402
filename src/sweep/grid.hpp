#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sweep/axis.hpp"

namespace sigmasweep {

class CalibrationCache;

/// All tuples of a sweep before `where`: groups of axes multiply, the last group fastest; the axes of one group
/// advance together. Index -> tuple is arithmetic.
class ParameterGrid {
 public:
  struct Member {
    const ParameterField* field;
    Axis axis;
  };
  using Group = std::vector<Member>;  ///< axes of one length; at least one

  /// `base` holds the parameters that are no axes, `gap` says which of s0 and sigma is given. What complete() needs
  /// much time for is worked out here, as long as it is not too much, and remembered.
  ParameterGrid(const Parameters& base, GapParameter gap, std::vector<Group> groups);

  std::uint64_t size() const { return size_; }
  /// The tuple, as complete() makes it. Safe from several threads at once.
  Parameters at(std::uint64_t index) const;
  const Parameters& base() const { return base_; }
  const std::vector<Group>& groups() const { return groups_; }
  const CalibrationCache& contacts() const { return *contacts_; }

 private:
  Parameters base_;
  GapParameter gap_;
  std::vector<Group> groups_;
  std::uint64_t size_ = 1;
  std::shared_ptr<const CalibrationCache> contacts_;
};

/// Number of tuples of these groups, which fits into 64 bits, and the values of one of them; the rest is `base`.
std::uint64_t size_of(const std::vector<ParameterGrid::Group>& groups);
Parameters values_at(const Parameters& base, const std::vector<ParameterGrid::Group>& groups, std::uint64_t index);

}  // namespace sigmasweep
