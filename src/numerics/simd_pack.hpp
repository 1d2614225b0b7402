#pragma once

#include <array>
#include <cstddef>

// Unrolls a loop over a few SIMD registers, so that they stay in registers. Not with sanitizers, which would add their
// checks to every copy.
#ifdef SIGMASWEEP_SANITIZED
#define SIGMASWEEP_UNROLL
#else
#define SIGMASWEEP_UNROLL _Pragma("GCC unroll 16")
#endif

namespace sigmasweep {

/// Eight neighbouring numbers with the same arithmetic: one register of AVX-512 or two of AVX2 for double,
/// loops for wide types.
template <class Real>
struct SimdPack {
  static constexpr std::size_t count = 8;
  std::array<Real, count> v{};

  SimdPack() = default;
  SimdPack(const Real& x) { v.fill(x); }
  Real& operator[](std::size_t i) { return v[i]; }
  const Real& operator[](std::size_t i) const { return v[i]; }

  template <class Operation>
  static SimdPack each(Operation operation) {
    SimdPack r;
    for (std::size_t i = 0; i < count; ++i) r.v[i] = operation(i);
    return r;
  }
  friend SimdPack operator+(const SimdPack& a, const SimdPack& b) {
    return each([&](std::size_t i) { return Real(a.v[i] + b.v[i]); });
  }
  friend SimdPack operator-(const SimdPack& a, const SimdPack& b) {
    return each([&](std::size_t i) { return Real(a.v[i] - b.v[i]); });
  }
  friend SimdPack operator*(const SimdPack& a, const SimdPack& b) {
    return each([&](std::size_t i) { return Real(a.v[i] * b.v[i]); });
  }
  friend SimdPack operator/(const SimdPack& a, const SimdPack& b) {
    return each([&](std::size_t i) { return Real(a.v[i] / b.v[i]); });
  }
  friend SimdPack magnitude(const SimdPack& a) {
    return each([&](std::size_t i) { return a.v[i] < 0 ? Real(-a.v[i]) : a.v[i]; });
  }
  /// c where a > b, else d, also where a or b is NaN.
  friend SimdPack where_above(const SimdPack& a, const SimdPack& b, const SimdPack& c, const SimdPack& d) {
    return each([&](std::size_t i) { return a.v[i] > b.v[i] ? c.v[i] : d.v[i]; });
  }
  /// b where a is zero, else c.
  friend SimdPack where_zero(const SimdPack& a, const SimdPack& b, const SimdPack& c) {
    return each([&](std::size_t i) { return a.v[i] == 0 ? b.v[i] : c.v[i]; });
  }
  /// The neighbours below: number i becomes a_{i-1}, number 0 the last one of `before`.
  friend SimdPack shifted_up(const SimdPack& before, const SimdPack& a) {
    return each([&](std::size_t i) { return i == 0 ? before.v[count - 1] : a.v[i - 1]; });
  }
  /// The neighbours above: number i becomes a_{i+1}, the last number the first one of `after`.
  friend SimdPack shifted_down(const SimdPack& a, const SimdPack& after) {
    return each([&](std::size_t i) { return i + 1 == count ? after.v[0] : a.v[i + 1]; });
  }
};

#ifdef __AVX512F__

template <>
struct SimdPack<double> {
  static constexpr std::size_t count = 8;
  typedef double Vector __attribute__((vector_size(64)));
  typedef long long Mask __attribute__((vector_size(64)));
  Vector v{};

  SimdPack() = default;
  SimdPack(double x) : v(Vector{} + x) {}
  double& operator[](std::size_t i) { return reinterpret_cast<double*>(&v)[i]; }
  double operator[](std::size_t i) const { return v[i]; }

  static SimdPack of(const Vector& v) {
    SimdPack r;
    r.v = v;
    return r;
  }
  friend SimdPack operator+(const SimdPack& a, const SimdPack& b) { return of(a.v + b.v); }
  friend SimdPack operator-(const SimdPack& a, const SimdPack& b) { return of(a.v - b.v); }
  friend SimdPack operator*(const SimdPack& a, const SimdPack& b) { return of(a.v * b.v); }
  friend SimdPack operator/(const SimdPack& a, const SimdPack& b) { return of(a.v / b.v); }
  friend SimdPack magnitude(const SimdPack& a) { return of(a.v < 0 ? -a.v : a.v); }
  friend SimdPack where_above(const SimdPack& a, const SimdPack& b, const SimdPack& c, const SimdPack& d) {
    return of(a.v > b.v ? c.v : d.v);
  }
  friend SimdPack where_zero(const SimdPack& a, const SimdPack& b, const SimdPack& c) {
    return of(a.v == 0 ? b.v : c.v);
  }
#ifdef __clang__
  friend SimdPack shifted_up(const SimdPack& before, const SimdPack& a) {
    return of(__builtin_shufflevector(before.v, a.v, 7, 8, 9, 10, 11, 12, 13, 14));
  }
  friend SimdPack shifted_down(const SimdPack& a, const SimdPack& after) {
    return of(__builtin_shufflevector(a.v, after.v, 1, 2, 3, 4, 5, 6, 7, 8));
  }
#else  // g++ before 12 does not have the other
  friend SimdPack shifted_up(const SimdPack& before, const SimdPack& a) {
    return of(__builtin_shuffle(before.v, a.v, Mask{7, 8, 9, 10, 11, 12, 13, 14}));
  }
  friend SimdPack shifted_down(const SimdPack& a, const SimdPack& after) {
    return of(__builtin_shuffle(a.v, after.v, Mask{1, 2, 3, 4, 5, 6, 7, 8}));
  }
#endif
};

#else

/// In two registers of AVX2: g++ 12 makes code of vectors twice as wide that is up to seven times as slow.
template <>
struct SimdPack<double> {
  static constexpr std::size_t count = 8;
  typedef double Vector __attribute__((vector_size(32)));
  typedef long long Mask __attribute__((vector_size(32)));
  Vector low{}, high{};

  SimdPack() = default;
  SimdPack(double x) : low(Vector{} + x), high(Vector{} + x) {}
  double& operator[](std::size_t i) { return reinterpret_cast<double*>(this)[i]; }
  double operator[](std::size_t i) const { return i < 4 ? low[i] : high[i - 4]; }

  static SimdPack of(const Vector& low, const Vector& high) {
    SimdPack r;
    r.low = low;
    r.high = high;
    return r;
  }
  friend SimdPack operator+(const SimdPack& a, const SimdPack& b) { return of(a.low + b.low, a.high + b.high); }
  friend SimdPack operator-(const SimdPack& a, const SimdPack& b) { return of(a.low - b.low, a.high - b.high); }
  friend SimdPack operator*(const SimdPack& a, const SimdPack& b) { return of(a.low * b.low, a.high * b.high); }
  friend SimdPack operator/(const SimdPack& a, const SimdPack& b) { return of(a.low / b.low, a.high / b.high); }
  friend SimdPack magnitude(const SimdPack& a) { return of(a.low < 0 ? -a.low : a.low, a.high < 0 ? -a.high : a.high); }
  friend SimdPack where_above(const SimdPack& a, const SimdPack& b, const SimdPack& c, const SimdPack& d) {
    return of(a.low > b.low ? c.low : d.low, a.high > b.high ? c.high : d.high);
  }
  friend SimdPack where_zero(const SimdPack& a, const SimdPack& b, const SimdPack& c) {
    return of(a.low == 0 ? b.low : c.low, a.high == 0 ? b.high : c.high);
  }
  friend SimdPack shifted_up(const SimdPack& before, const SimdPack& a) {
    return of(up(before.high, a.low), up(a.low, a.high));
  }
  friend SimdPack shifted_down(const SimdPack& a, const SimdPack& after) {
    return of(down(a.low, a.high), down(a.high, after.low));
  }

 private:
#ifdef __clang__
  static Vector up(const Vector& before, const Vector& a) { return __builtin_shufflevector(before, a, 3, 4, 5, 6); }
  static Vector down(const Vector& a, const Vector& after) { return __builtin_shufflevector(a, after, 1, 2, 3, 4); }
#else  // g++ before 12 does not have the other
  static Vector up(const Vector& before, const Vector& a) { return __builtin_shuffle(before, a, Mask{3, 4, 5, 6}); }
  static Vector down(const Vector& a, const Vector& after) { return __builtin_shuffle(a, after, Mask{1, 2, 3, 4}); }
#endif
};

#endif

}  // namespace sigmasweep
