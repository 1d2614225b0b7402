#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sigmasweep {

/// Are error bars true, and not too wide? Told of errors and bars, it counts.
class ErrorBars {
 public:
  void see(double error, double bar) {
    ++results_;
    held_ += error <= bar;
    if (error > 0.0) overestimates_.push_back(bar / error);
  }
  /// At least so many, and 99 % of them true.
  void expect_true(int at_least) const {
    EXPECT_GE(results_, at_least);
    EXPECT_GE(held_, 0.99 * results_) << held_ << " of " << results_;
  }
  /// Half of them are no more than so many times the error.
  void expect_useful(double factor) {
    std::ranges::sort(overestimates_);
    ASSERT_FALSE(overestimates_.empty());
    EXPECT_LE(overestimates_[overestimates_.size() / 2], factor);
  }

 private:
  int results_ = 0, held_ = 0;
  std::vector<double> overestimates_;
};

}  // namespace sigmasweep
