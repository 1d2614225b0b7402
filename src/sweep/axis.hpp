#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "sigmasweep/model/exact_number.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sweep/sampling.hpp"

namespace sigmasweep {

/// The interval of an axis, with its end points.
struct Interval {
  AnyNumber from = 0, to = 0;
  bool log = false;    ///< values are evenly spaced in the logarithm; from, to > 0
  bool whole = false;  ///< values are whole numbers
};

/// A normal distribution of the values, or of their logarithms (then mean and sd are those of the logarithm).
struct NormalDistribution {
  double mean = 0.0, sd = 0.0;
  bool log = false;
};

enum class SampleKind : std::uint8_t { uniform, sobol, latin_hypercube };

/// The method of sampling an interval.
struct Sampling {
  SampleKind kind = SampleKind::uniform;
  std::uint64_t key = 0;      ///< from stream_key(); sobol: a digital shift, 0 for the plain sequence
  std::size_t dimension = 0;  ///< sobol: dimension of the sequence
};

/// The values of a parameter, by index. Ranges and samples are computed when they are used, so that an axis of 2^40
/// values needs no memory. An enumerator's value is its number. End points are exact, 64-bit integers, too. Values
/// between them are computed in extended precision from the end points as decimals, so that each is the double that a
/// user would write: ten values from 0.1 to 1 are 0.1, 0.2, 0.3 ..., and a logarithmic range hits its decades.
class Axis {
 public:
  static Axis list(std::vector<AnyNumber> values);
  /// `count` values from interval.from to interval.to, both included. A logarithmic range of whole numbers is rounded,
  /// and repeated values are dropped. A linear range of whole numbers must have a whole step (see has_whole_step).
  static Axis range(const Interval& interval, std::uint64_t count);
  static Axis sample(const Interval& interval, std::uint64_t count, const Sampling& sampling);
  /// A sample of a normal distribution that is cut off at the ends of `within`, which may be infinite.
  static Axis normal_sample(const NormalDistribution& normal, const Interval& within, std::uint64_t count,
                            const Sampling& sampling);

  std::uint64_t size() const;
  AnyNumber operator[](std::uint64_t k) const;
  /// The smallest interval that is known to include all values.
  std::pair<AnyNumber, AnyNumber> bounds() const;

 private:
  /// An interval with its end points as decimals, or with the logarithms of these.
  struct Scale {
    explicit Scale(const Interval& interval);
    /// The value that divides the interval into parts of these lengths, on a logarithmic scale of the logarithm.
    AnyNumber divided(long double from_start, long double to_end) const;
    Interval interval;
    long double start, end;
  };
  struct Range {
    Scale scale;
    std::uint64_t count;
    AnyNumber point(std::uint64_t k) const;
  };
  struct Normal {
    Normal(const NormalDistribution& normal, const Interval& within);
    /// The value below which a share u of the distribution lies.
    AnyNumber at(double u) const;
    NormalDistribution distribution;
    Interval within;
    double below, above;  ///< shares of the whole distribution below the ends
  };
  struct Sample {
    std::variant<Scale, Normal> distribution;
    std::uint64_t count;
    Sampling sampling;
    SobolDimension sobol;
    double unit(std::uint64_t k) const;  ///< in [0, 1]
    double to_middle() const;            ///< of the part of [0, 1] that belongs to a point of a normal sample
    AnyNumber point(std::uint64_t k) const;
  };
  using Values = std::variant<std::vector<AnyNumber>, Range, Sample>;
  explicit Axis(Values values) : values_(std::move(values)) {}
  Axis tabulated() &&;

  Values values_;
};

/// Whether `count` evenly spaced values of an interval of whole numbers are all whole numbers.
bool has_whole_step(const Interval& interval, std::uint64_t count);

}  // namespace sigmasweep
