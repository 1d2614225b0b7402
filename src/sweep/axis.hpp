#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "sweep/sampling.hpp"

namespace sigmasweep {

/// The numbers between two end points, evenly spaced themselves or by their logarithms (then from, to > 0);
/// `whole`: only whole numbers.
struct Interval {
  double from = 0.0, to = 0.0;
  bool log = false, whole = false;
};

enum class SampleKind : std::uint8_t { uniform, sobol, latin_hypercube };

/// How an interval is sampled. `key` from stream_key(); for sobol it is a digital shift, 0 the plain sequence.
struct Sampling {
  SampleKind kind = SampleKind::uniform;
  std::uint64_t key = 0;
  std::size_t dimension = 0;  ///< sobol: which dimension of the sequence
};

/// The values that a parameter takes, by index. Ranges and samples are computed, not stored, so that an axis of 2^40
/// values costs no memory. Enumerators are their numbers. End points are exact. What lies between them is computed in
/// extended precision from the end points as decimals, so that it is the double that a user would write: ten values
/// from 0.1 to 1 are 0.1, 0.2, 0.3 ..., and a logarithmic range hits its decades.
class Axis {
 public:
  static Axis list(std::vector<double> values);
  /// `count` values from interval.from to interval.to, both included. A logarithmic range of whole numbers is rounded,
  /// and values that repeat are dropped. A linear range of whole numbers must have a whole step (see has_whole_step).
  static Axis range(const Interval& interval, std::uint64_t count);
  static Axis sample(const Interval& interval, std::uint64_t count, const Sampling& sampling);

  std::uint64_t size() const;
  double operator[](std::uint64_t k) const;
  /// A smallest interval known to hold all values.
  std::pair<double, double> bounds() const;

 private:
  /// An interval with its end points as they were written, or their logarithms.
  struct Scale {
    explicit Scale(const Interval& interval);
    /// The value that divides the interval in parts of these lengths (of the logarithm for a logarithmic one).
    double divided(long double from_start, long double to_end) const;
    Interval interval;
    long double start, end;
  };
  struct Range {
    Scale scale;
    std::uint64_t count;
    double point(std::uint64_t k) const;
  };
  struct Sample {
    Scale scale;
    std::uint64_t count;
    Sampling sampling;
    SobolDimension sobol;
    double unit(std::uint64_t k) const;  ///< in [0, 1]
    double point(std::uint64_t k) const;
  };
  using Values = std::variant<std::vector<double>, Range, Sample>;
  explicit Axis(Values values) : values_(std::move(values)) {}
  Axis tabulated() &&;

  Values values_;
};

/// Whether a linear range of whole numbers lands on whole numbers.
bool has_whole_step(const Interval& interval, std::uint64_t count);

}  // namespace sigmasweep
