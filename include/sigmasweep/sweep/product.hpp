#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sigmasweep/scene/parameters.hpp"
#include "sigmasweep/sweep/axis.hpp"
#include "sigmasweep/sweep/fields.hpp"

namespace sigmasweep {

/// All tuples of a sweep before `where`: groups of axes multiply, the last group fastest; the axes of one group
/// advance together. Index -> tuple is arithmetic.
class Product {
 public:
  struct Member {
    const Field* field;
    Axis axis;
  };
  using Group = std::vector<Member>;  ///< axes of one length; at least one

  /// `base` holds the parameters that are no axes, `gap` says which of s0 and sigma is given.
  Product(const Parameters& base, Gap gap, std::vector<Group> groups);

  std::uint64_t size() const { return size_; }
  Parameters at(std::uint64_t index) const;

 private:
  Parameters base_;
  Gap gap_;
  std::vector<Group> groups_;
  std::uint64_t size_ = 1;
};

}  // namespace sigmasweep
