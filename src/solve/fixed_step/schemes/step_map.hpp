#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

namespace sigmasweep {

/// A damped mode x'' + c x' + k x = 0. With time in steps k = (omega dt)^2 and c = 2 zeta omega dt.
struct Mode {
  double k = 0.0, c = 0.0;
  Mode in_steps(double dt) const { return {k * dt * dt, c * dt}; }
};

/// The linear map that one step of a scheme is for a mode: a square matrix of up to 6 x 6.
/// Its entries are wide: where the step is short two eigenvalues e^(+-i omega dt) nearly meet, and lose half of the
/// digits.
class StepMap {
 public:
  using Wide = long double;
  static constexpr std::size_t max_size = 6;

  explicit StepMap(std::size_t size) : size_(size) {}
  /// Entries row by row.
  StepMap(std::size_t size, std::initializer_list<Wide> entries) : size_(size) {
    std::size_t next = 0;
    for (const Wide entry : entries) entries_[next++] = entry;
  }

  std::size_t size() const { return size_; }
  Wide& operator()(std::size_t row, std::size_t column) { return entries_[row * size_ + column]; }
  Wide operator()(std::size_t row, std::size_t column) const { return entries_[row * size_ + column]; }

 private:
  std::size_t size_;
  std::array<Wide, max_size * max_size> entries_{};
};

}  // namespace sigmasweep
