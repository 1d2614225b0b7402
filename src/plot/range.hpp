#pragma once

#include <algorithm>
#include <limits>

namespace sigmasweep::plot {

/// The smallest range that includes all numbers given to it, without NaN.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return !(low <= high); }
};

}  // namespace sigmasweep::plot
