#pragma once

#include <array>
#include <cstddef>

// A loop over a few registers, unrolled so that they are registers. Sanitizers would put their checks into every copy.
#ifdef SIGMASWEEP_SANITIZED
#define SIGMASWEEP_UNROLL
#else
#define SIGMASWEEP_UNROLL _Pragma("GCC unroll 16")
#endif

namespace sigmasweep {

/// Eight neighbouring numbers that go through the same arithmetic: one AVX-512 register (or what the machine has) for
/// double, plain loops for the wide types.
template <class Real>
struct Lanes {
  static constexpr std::size_t count = 8;
  std::array<Real, count> v{};

  Lanes() = default;
  Lanes(const Real& x) { v.fill(x); }
  Real& operator[](std::size_t i) { return v[i]; }
  const Real& operator[](std::size_t i) const { return v[i]; }

  template <class Operation>
  static Lanes each(Operation operation) {
    Lanes r;
    for (std::size_t i = 0; i < count; ++i) r.v[i] = operation(i);
    return r;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return Real(a.v[i] + b.v[i]); });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return Real(a.v[i] - b.v[i]); });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return Real(a.v[i] * b.v[i]); });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](std::size_t i) { return Real(a.v[i] / b.v[i]); });
  }
  friend Lanes magnitude(const Lanes& a) {
    return each([&](std::size_t i) { return a.v[i] < 0 ? Real(-a.v[i]) : a.v[i]; });
  }
  /// c where a > b, else d (where one is NaN, too).
  friend Lanes where_above(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    return each([&](std::size_t i) { return a.v[i] > b.v[i] ? c.v[i] : d.v[i]; });
  }
  /// b where a is zero, else c.
  friend Lanes where_zero(const Lanes& a, const Lanes& b, const Lanes& c) {
    return each([&](std::size_t i) { return a.v[i] == 0 ? b.v[i] : c.v[i]; });
  }
  /// The neighbours below: lane i becomes a_{i-1}, lane 0 the last of `before`.
  friend Lanes shifted_up(const Lanes& before, const Lanes& a) {
    return each([&](std::size_t i) { return i == 0 ? before.v[count - 1] : a.v[i - 1]; });
  }
  /// The neighbours above: lane i becomes a_{i+1}, the last lane the first of `after`.
  friend Lanes shifted_down(const Lanes& a, const Lanes& after) {
    return each([&](std::size_t i) { return i + 1 == count ? after.v[0] : a.v[i + 1]; });
  }
};

template <>
struct Lanes<double> {
  static constexpr std::size_t count = 8;
  typedef double Vector __attribute__((vector_size(64)));
  typedef long long Mask __attribute__((vector_size(64)));
  Vector v{};

  Lanes() = default;
  Lanes(double x) : v(Vector{} + x) {}
  double& operator[](std::size_t i) { return reinterpret_cast<double*>(&v)[i]; }
  double operator[](std::size_t i) const { return v[i]; }

  static Lanes of(const Vector& v) {
    Lanes r;
    r.v = v;
    return r;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return of(a.v + b.v); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return of(a.v - b.v); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return of(a.v * b.v); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return of(a.v / b.v); }
  friend Lanes magnitude(const Lanes& a) { return of(a.v < 0 ? -a.v : a.v); }
  friend Lanes where_above(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    return of(a.v > b.v ? c.v : d.v);
  }
  friend Lanes where_zero(const Lanes& a, const Lanes& b, const Lanes& c) { return of(a.v == 0 ? b.v : c.v); }
  friend Lanes shifted_up(const Lanes& before, const Lanes& a) {
    return of(__builtin_shuffle(before.v, a.v, Mask{7, 8, 9, 10, 11, 12, 13, 14}));
  }
  friend Lanes shifted_down(const Lanes& a, const Lanes& after) {
    return of(__builtin_shuffle(a.v, after.v, Mask{1, 2, 3, 4, 5, 6, 7, 8}));
  }
};

}  // namespace sigmasweep
