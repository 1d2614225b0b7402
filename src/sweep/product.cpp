#include "sigmasweep/sweep/product.hpp"

#include <cassert>
#include <utility>

namespace sigmasweep {

Product::Product(const Parameters& base, Gap gap, std::vector<Group> groups)
    : base_(base), gap_(gap), groups_(std::move(groups)) {
  for (const Group& group : groups_) size_ *= group.front().axis.size();
}

Parameters Product::at(std::uint64_t index) const {
  assert(index < size_);
  Row row;
  row.parameters = base_;
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
    const std::uint64_t length = group->front().axis.size();
    for (const Member& member : *group) set_number(*member.field, row, member.axis[index % length]);
    index /= length;
  }
  return complete(row.parameters, gap_);
}

}  // namespace sigmasweep
