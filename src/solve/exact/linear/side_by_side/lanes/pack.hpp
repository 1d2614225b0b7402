#pragma once

#include <cstdint>

#ifdef __AVX2__
#include <immintrin.h>
#endif

/// W numbers, one a lane, with the same arithmetic. Every operation is one lane's own and rounds once, so that a lane's
/// bits depend neither on W nor on its neighbours; sources that use packs are compiled without contraction. The
/// functions are templates on W and force-inlined: a source for a better processor leaves no code that others could
/// come to call.
namespace sigmasweep::side_by_side {

#define SIGMASWEEP_LANEWISE [[gnu::always_inline]] inline
#define SIGMASWEEP_INLINE_LAMBDA __attribute__((always_inline))

template <int W>
struct Vectors {
  typedef double Number __attribute__((vector_size(8 * W)));
  typedef long long Bits __attribute__((vector_size(8 * W)));
};
template <>
struct Vectors<1> {
  using Number = double;
  using Bits = long long;
};

/// A yes or no a lane: all bits or none.
template <int W>
struct Mask {
  typename Vectors<W>::Bits v;

  SIGMASWEEP_LANEWISE static Mask load(const long long* from) {
    Mask m;
    __builtin_memcpy(&m.v, from, sizeof m.v);
    return m;
  }
  SIGMASWEEP_LANEWISE static Mask none() { return {typename Vectors<W>::Bits{}}; }
  SIGMASWEEP_LANEWISE void store(long long* to) const { __builtin_memcpy(to, &v, sizeof v); }
  SIGMASWEEP_LANEWISE friend Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
  SIGMASWEEP_LANEWISE friend Mask operator|(Mask a, Mask b) { return {a.v | b.v}; }
  SIGMASWEEP_LANEWISE friend Mask operator~(Mask a) { return {~a.v}; }
};

template <int W>
struct Pack {
  using Number = typename Vectors<W>::Number;
  using Bits = typename Vectors<W>::Bits;
  Number v;

  Pack() = default;
  SIGMASWEEP_LANEWISE Pack(double x) {
    if constexpr (W == 1)
      v = x;
    else
      v = Number{} + x;
  }
  SIGMASWEEP_LANEWISE static Pack of(Number v) {
    Pack p;
    p.v = v;
    return p;
  }
  SIGMASWEEP_LANEWISE static Pack load(const double* from) {
    Pack p;
    __builtin_memcpy(&p.v, from, sizeof p.v);
    return p;
  }
  SIGMASWEEP_LANEWISE void store(double* to) const { __builtin_memcpy(to, &v, sizeof v); }
  SIGMASWEEP_LANEWISE friend Pack operator+(Pack a, Pack b) { return of(a.v + b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator-(Pack a, Pack b) { return of(a.v - b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator*(Pack a, Pack b) { return of(a.v * b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator/(Pack a, Pack b) { return of(a.v / b.v); }
  SIGMASWEEP_LANEWISE friend Mask<W> operator<(Pack a, Pack b) { return b > a; }
  SIGMASWEEP_LANEWISE friend Mask<W> operator>(Pack a, Pack b) {
    if constexpr (W == 1)
      return {-static_cast<long long>(a.v > b.v)};
    else
      return {a.v > b.v};
  }
  SIGMASWEEP_LANEWISE friend Mask<W> operator==(Pack a, Pack b) {
    if constexpr (W == 1)
      return {-static_cast<long long>(a.v == b.v)};
    else
      return {a.v == b.v};
  }
};

/// a where the mask is set, else b.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> select(Mask<W> mask, Pack<W> a, Pack<W> b) {
  return Pack<W>::of(mask.v ? a.v : b.v);
}
/// The same of masks.
template <int W>
SIGMASWEEP_LANEWISE Mask<W> select_mask(Mask<W> mask, Mask<W> a, Mask<W> b) {
  return (mask & a) | (~mask & b);
}
template <int W>
SIGMASWEEP_LANEWISE typename Vectors<W>::Bits bits_of(Pack<W> a) {
  typename Vectors<W>::Bits bits;
  __builtin_memcpy(&bits, &a.v, sizeof bits);
  return bits;
}
template <int W>
SIGMASWEEP_LANEWISE Pack<W> from_bits(typename Vectors<W>::Bits bits) {
  Pack<W> a;
  __builtin_memcpy(&a.v, &bits, sizeof bits);
  return a;
}
/// a where the mask is set, else 0.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> where(Mask<W> mask, Pack<W> a) {
  return from_bits<W>(bits_of(a) & mask.v);
}
/// -a where the mask is set, else a.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> negated_where(Mask<W> mask, Pack<W> a) {
  return from_bits<W>(bits_of(a) ^ (mask.v & static_cast<long long>(0x8000'0000'0000'0000)));
}
template <int W>
SIGMASWEEP_LANEWISE Pack<W> magnitude(Pack<W> a) {
  return from_bits<W>(bits_of(a) & 0x7fff'ffff'ffff'ffff);
}

/// a b + c, rounded once.
SIGMASWEEP_LANEWISE double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
#ifdef __FMA__
SIGMASWEEP_LANEWISE __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
#endif
#ifdef __AVX512F__
SIGMASWEEP_LANEWISE __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
#endif
template <int W>
SIGMASWEEP_LANEWISE Pack<W> fma(Pack<W> a, Pack<W> b, Pack<W> c) {
  return Pack<W>::of(fused(a.v, b.v, c.v));
}
/// The smaller and the larger one; b where a or b is NaN.
template <int W>
SIGMASWEEP_LANEWISE Pack<W> least(Pack<W> a, Pack<W> b) {
  return select(b > a, a, b);
}
template <int W>
SIGMASWEEP_LANEWISE Pack<W> most(Pack<W> a, Pack<W> b) {
  return select(a > b, a, b);
}

/// Bit l is set where lane l says yes.
SIGMASWEEP_LANEWISE unsigned signs(long long v) { return v < 0; }
#ifdef __AVX__
SIGMASWEEP_LANEWISE unsigned signs(Vectors<4>::Bits v) {
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(v)));
}
#endif
#ifdef __AVX512DQ__
SIGMASWEEP_LANEWISE unsigned signs(Vectors<8>::Bits v) { return _mm512_movepi64_mask(reinterpret_cast<__m512i>(v)); }
#endif
template <int W>
SIGMASWEEP_LANEWISE unsigned lanes_of(Mask<W> m) {
  return signs(m.v);
}
template <int W>
SIGMASWEEP_LANEWISE bool any(Mask<W> m) {
  return lanes_of(m) != 0;
}

}  // namespace sigmasweep::side_by_side
