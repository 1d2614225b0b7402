#include "sweep/axis.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <boost/math/distributions/normal.hpp>

namespace sigmasweep {
namespace {

/// Largest length of an axis whose values are stored.
constexpr std::uint64_t tabulate_up_to = 4096;

/// An end point: a whole number, or the shortest decimal that reads back as the same double, in extended precision:
/// 1e-7 with 19 digits instead of 16.
long double as_written(AnyNumber end, bool whole) {
  if (whole) return end;
  const auto value = static_cast<double>(end);
  const std::string decimal = fmt::format("{}", value);
  long double exact = value;
  std::from_chars(decimal.data(), decimal.data() + decimal.size(), exact);
  return exact;
}

}  // namespace

Axis::Scale::Scale(const Interval& given)
    : interval(given), start(as_written(given.from, given.whole)), end(as_written(given.to, given.whole)) {
  if (!interval.log) return;
  start = std::log(start);
  end = std::log(end);
}

AnyNumber Axis::Scale::divided(long double from_start, long double to_end) const {
  if (from_start == 0) return interval.from;
  const long double mean = (start * to_end + end * from_start) / (from_start + to_end);
  const long double value = interval.log ? std::exp(mean) : mean;
  const auto [low, high] = std::minmax(interval.from, interval.to);
  return std::clamp<AnyNumber>(interval.whole ? std::round(value) : static_cast<double>(value), low, high);
}

AnyNumber Axis::Range::point(std::uint64_t k) const {
  if (k == 0) return scale.interval.from;
  const Interval& interval = scale.interval;
  if (k == count - 1) return interval.to;
  if (interval.whole && !interval.log)
    return interval.from +
           (interval.to - interval.from) / static_cast<AnyNumber>(count - 1) * static_cast<AnyNumber>(k);
  return scale.divided(static_cast<long double>(k), static_cast<long double>(count - 1 - k));
}

AnyNumber Axis::Sample::point(std::uint64_t k) const {
  const double u = unit(k);
  if (const auto* normal = std::get_if<Normal>(&distribution)) return normal->at(u + to_middle());
  const Scale& scale = std::get<Scale>(distribution);
  const Interval& interval = scale.interval;
  if (!interval.whole || interval.log) return scale.divided(u, 1.0L - u);
  // Each whole number has an equal part of [0, 1).
  const auto numbers = static_cast<double>(interval.to - interval.from + 1);
  return std::min<AnyNumber>(interval.to, interval.from + std::floor(u * numbers));
}

Axis::Normal::Normal(const NormalDistribution& normal, const Interval& ends)
    : distribution(normal), within(ends), below(0.0), above(1.0) {
  const boost::math::normal_distribution<double> curve(normal.mean, normal.sd);
  const auto share = [&](AnyNumber end) {
    const auto value = static_cast<double>(end);
    return cdf(curve, normal.log ? std::log(value) : value);
  };
  if (std::isfinite(within.from) && !(normal.log && within.from <= 0)) below = share(within.from);
  if (std::isfinite(within.to)) above = share(within.to);
}

AnyNumber Axis::Normal::at(double u) const {
  constexpr double least = 0x1p-54;  // half of the least number of a sample above 0
  const double all = std::clamp(below + (above - below) * (u + least), least, 1.0 - 2.0 * least);
  const double value = quantile(boost::math::normal_distribution<double>(distribution.mean, distribution.sd), all);
  const double number = distribution.log ? std::exp(value) : value;
  return std::clamp<AnyNumber>(within.whole ? std::round(number) : number, within.from, within.to);
}

bool has_whole_step(const Interval& interval, std::uint64_t count) {
  if (count < 2) return true;
  return std::fmod(interval.to - interval.from, static_cast<AnyNumber>(count - 1)) == 0;
}

Axis Axis::list(std::vector<AnyNumber> values) { return Axis(Values(std::move(values))); }

Axis Axis::range(const Interval& interval, std::uint64_t count) {
  assert(count > 0);
  const Range range{Scale(interval), count};
  if (!interval.whole || !interval.log) return Axis(Values(range)).tabulated();
  std::vector<AnyNumber> values;
  for (std::uint64_t k = 0; k < count; ++k)
    if (const AnyNumber value = range.point(k); values.empty() || values.back() != value) values.push_back(value);
  return list(std::move(values));
}

Axis Axis::sample(const Interval& interval, std::uint64_t count, const Sampling& sampling) {
  assert(count > 0);
  return Axis(Values(Sample{Scale(interval), count, sampling, SobolDimension(sampling.dimension)})).tabulated();
}

Axis Axis::normal_sample(const NormalDistribution& normal, const Interval& within, std::uint64_t count,
                         const Sampling& sampling) {
  assert(count > 0);
  return Axis(Values(Sample{Normal(normal, within), count, sampling, SobolDimension(sampling.dimension)})).tabulated();
}

Axis Axis::tabulated() && {
  if (size() > tabulate_up_to) return std::move(*this);
  std::vector<AnyNumber> values(size());
  for (std::uint64_t k = 0; k < values.size(); ++k) values[k] = (*this)[k];
  return list(std::move(values));
}

/// The plain Sobol sequence begins with 0, the end of a normal distribution, and its first 2^m points are the lower
/// ends of 2^m equal parts: half of a part leads to the middle of it.
double Axis::Sample::to_middle() const {
  const bool plain = sampling.kind == SampleKind::sobol && sampling.key == 0;
  return plain ? 0.5 / static_cast<double>(std::bit_ceil(count)) : 0.0;
}

double Axis::Sample::unit(std::uint64_t k) const {
  switch (sampling.kind) {
    case SampleKind::uniform: return unit_interval(random_bits(sampling.key, k));
    case SampleKind::sobol: return unit_interval(sobol.bits(k) ^ sampling.key);
    case SampleKind::latin_hypercube: {
      // One value in each of `count` equal strata, in shuffled order.
      const std::uint64_t stratum = shuffled(k, count, random_bits(sampling.key, count));
      const double within = unit_interval(random_bits(sampling.key, k));
      return (static_cast<double>(stratum) + within) / static_cast<double>(count);
    }
  }
  assert(false);
  return 0.0;
}

std::uint64_t Axis::size() const {
  if (const auto* values = std::get_if<std::vector<AnyNumber>>(&values_)) return values->size();
  if (const auto* range = std::get_if<Range>(&values_)) return range->count;
  return std::get<Sample>(values_).count;
}

AnyNumber Axis::operator[](std::uint64_t k) const {
  assert(k < size());
  if (const auto* values = std::get_if<std::vector<AnyNumber>>(&values_)) return (*values)[k];
  if (const auto* range = std::get_if<Range>(&values_)) return range->point(k);
  return std::get<Sample>(values_).point(k);
}

std::pair<AnyNumber, AnyNumber> Axis::bounds() const {
  if (const auto* values = std::get_if<std::vector<AnyNumber>>(&values_)) {
    const auto [low, high] = std::minmax_element(values->begin(), values->end());
    return {*low, *high};
  }
  if (const auto* range = std::get_if<Range>(&values_))
    return std::minmax(range->scale.interval.from, range->scale.interval.to);
  const auto& distribution = std::get<Sample>(values_).distribution;
  if (const auto* normal = std::get_if<Normal>(&distribution)) return {normal->at(0.0), normal->at(1.0)};
  const Interval& interval = std::get<Scale>(distribution).interval;
  return std::minmax(interval.from, interval.to);
}

}  // namespace sigmasweep
