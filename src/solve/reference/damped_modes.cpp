#include "solve/reference/damped_modes.hpp"

#include <cmath>
#include <numbers>

namespace sigmasweep {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

/// What the ends of a run leave of the shapes of modes k = j + 1:
/// free:     sin(m theta), m = 1..c,           theta = k pi/(c+1):           zero at both ends;
/// at_wall:  cos((m + 1/2) theta), m = 0..c-1, theta = (2k-1) pi/(2c+1):     even about the wall's contact, zero above;
/// matched:  W x = cos(m theta),               theta = (2k-1) pi/(2c):       even about the wall itself, zero above.
long double angle(RunKind kind, std::size_t c, std::size_t j) {
  const auto n = static_cast<long double>(c), k = static_cast<long double>(j + 1);
  switch (kind) {
    case RunKind::free: return k * pi / (n + 1);
    case RunKind::at_wall: return (2 * k - 1) * pi / (2 * n + 1);
    case RunKind::at_matched_wall: return (2 * k - 1) * pi / (2 * n);
  }
  return 0;
}

/// sin(pi a/b), with the angle brought to the first octants in whole numbers.
long double sin_of(std::size_t a, std::size_t b) {
  a %= 2 * b;
  if (a > b) return -sin_of(a - b, b);
  if (2 * a > b) a = b - a;
  return std::sin(pi * static_cast<long double>(a) / static_cast<long double>(b));
}
/// cos(pi a/b) = sin(pi (2a + b)/(2b))
long double cos_of(std::size_t a, std::size_t b) { return sin_of(2 * a + b, 2 * b); }

DampedModes make(RunKind kind, std::size_t c) {
  DampedModes modes;
  modes.shape.resize(c * c);
  modes.analysis.resize(c * c);
  for (std::size_t j = 0; j < c; ++j) {
    const long double half = std::sin(angle(kind, c, j) / 2);
    modes.lambda.push_back(4 * half * half);
  }
  const long double norm = std::sqrt(kind == RunKind::free      ? 2 / static_cast<long double>(c + 1)
                                     : kind == RunKind::at_wall ? 4 / static_cast<long double>(2 * c + 1)
                                                                : 2 / static_cast<long double>(c));
  for (std::size_t m = 0; m < c; ++m)
    for (std::size_t j = 0; j < c; ++j) {
      long double& shape = modes.shape[m * c + j];
      long double& analysis = modes.analysis[m * c + j];
      const std::size_t k = j + 1;
      if (kind == RunKind::free) shape = analysis = norm * sin_of((m + 1) * k, c + 1);
      if (kind == RunKind::at_wall) shape = analysis = norm * cos_of((2 * m + 1) * (2 * k - 1), 2 * (2 * c + 1));
      if (kind == RunKind::at_matched_wall) {
        const long double force = norm * cos_of(m * (2 * k - 1), 2 * c);
        shape = m == 0 ? force / 2 : force;
        analysis = force;  // the inner product has W as its weight
      }
    }
  return modes;
}

}  // namespace

const DampedModes& ModeTables::of(RunKind kind, std::size_t contacts) {
  const auto found = tables_.find({kind, contacts});
  if (found != tables_.end()) return found->second;
  return tables_.emplace(std::pair(kind, contacts), make(kind, contacts)).first->second;
}

Propagator propagator(long double mu, long double omega2, long double t) {
  const long double delta = omega2 - mu * mu, z = delta * t * t;
  long double c, s;  // cos(sqrt z), t sin(sqrt z)/sqrt z
  if (z > 1) {
    const long double w = std::sqrt(delta);
    c = std::cos(w * t);
    s = std::sin(w * t) / w;
  } else if (z < -1) {
    const long double w = std::sqrt(-delta);
    c = std::cosh(w * t);
    s = std::sinh(w * t) / w;
  } else {
    c = s = 1;
    long double even = 1, odd = 1;
    for (int n = 1; n <= 11; ++n) {  // 1/22! = 9e-22
      even *= -z / static_cast<long double>((2 * n - 1) * (2 * n));
      odd *= -z / static_cast<long double>((2 * n) * (2 * n + 1));
      c += even;
      s += odd;
    }
    s *= t;
  }
  const long double decay = std::exp(-mu * t);
  return {decay * (c + mu * s), decay * s, -decay * omega2 * s, decay * (c - mu * s)};
}

}  // namespace sigmasweep
