#pragma once

#include <cstddef>
#include <vector>

namespace sigmasweep {

/// An array with one number per contact (or component), padded to whole vectors of the machine, with room on either
/// side for a stencil.
class AlignedLanes {
 public:
  static constexpr std::size_t width = 4;
  static constexpr std::size_t padded(std::size_t contacts) { return (contacts + width - 1) / width * width; }
  explicit AlignedLanes(std::size_t contacts, double value = 0.0) : data_(padded(contacts) + 2 * width, value) {}
  double* data() { return data_.data() + width; }
  const double* data() const { return data_.data() + width; }
  double& operator[](std::size_t k) { return data()[k]; }
  double operator[](std::size_t k) const { return data()[k]; }

 private:
  std::vector<double> data_;
};

}  // namespace sigmasweep
