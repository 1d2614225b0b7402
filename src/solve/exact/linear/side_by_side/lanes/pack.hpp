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

template <int W, class T = double>
struct Vectors;
template <int W>
struct Vectors<W, double> {
  typedef double Number __attribute__((vector_size(8 * W)));
  typedef long long Bits __attribute__((vector_size(8 * W)));
  static constexpr long long sign = static_cast<long long>(0x8000'0000'0000'0000);
};
template <>
struct Vectors<1, double> {
  using Number = double;
  using Bits = long long;
  static constexpr long long sign = static_cast<long long>(0x8000'0000'0000'0000);
};
template <int W>
struct Vectors<W, float> {
  typedef float Number __attribute__((vector_size(4 * W)));
  typedef int Bits __attribute__((vector_size(4 * W)));
  static constexpr int sign = static_cast<int>(0x8000'0000);
};

/// A yes or no a lane: all bits or none.
template <int W, class T = double>
struct Mask {
  using Bits = typename Vectors<W, T>::Bits;
  Bits v;

  template <class Flag>
  SIGMASWEEP_LANEWISE static Mask load(const Flag* from) {
    Mask m;
    static_assert(sizeof(Flag) == sizeof(T));
    __builtin_memcpy(&m.v, from, sizeof m.v);
    return m;
  }
  SIGMASWEEP_LANEWISE static Mask none() { return {Bits{}}; }
  template <class Flag>
  SIGMASWEEP_LANEWISE void store(Flag* to) const {
    static_assert(sizeof(Flag) == sizeof(T));
    __builtin_memcpy(to, &v, sizeof v);
  }
  SIGMASWEEP_LANEWISE friend Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
  SIGMASWEEP_LANEWISE friend Mask operator|(Mask a, Mask b) { return {a.v | b.v}; }
  SIGMASWEEP_LANEWISE friend Mask operator~(Mask a) { return {~a.v}; }
};

template <int W, class T = double>
struct Pack {
  using Number = typename Vectors<W, T>::Number;
  using Bits = typename Vectors<W, T>::Bits;
  using Scalar = T;
  Number v;

  Pack() = default;
  SIGMASWEEP_LANEWISE Pack(T x) {
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
  SIGMASWEEP_LANEWISE static Pack load(const T* from) {
    Pack p;
    __builtin_memcpy(&p.v, from, sizeof p.v);
    return p;
  }
  SIGMASWEEP_LANEWISE void store(T* to) const { __builtin_memcpy(to, &v, sizeof v); }
  SIGMASWEEP_LANEWISE friend Pack operator+(Pack a, Pack b) { return of(a.v + b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator-(Pack a, Pack b) { return of(a.v - b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator*(Pack a, Pack b) { return of(a.v * b.v); }
  SIGMASWEEP_LANEWISE friend Pack operator/(Pack a, Pack b) { return of(a.v / b.v); }
  SIGMASWEEP_LANEWISE friend Mask<W, T> operator<(Pack a, Pack b) { return b > a; }
  SIGMASWEEP_LANEWISE friend Mask<W, T> operator>(Pack a, Pack b) {
    if constexpr (W == 1)
      return {-static_cast<Bits>(a.v > b.v)};
    else
      return {a.v > b.v};
  }
  SIGMASWEEP_LANEWISE friend Mask<W, T> operator==(Pack a, Pack b) {
    if constexpr (W == 1)
      return {-static_cast<Bits>(a.v == b.v)};
    else
      return {a.v == b.v};
  }
};

/// a where the mask is set, else b.
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> select(Mask<W, T> mask, Pack<W, T> a, Pack<W, T> b) {
  return Pack<W, T>::of(mask.v ? a.v : b.v);
}
/// The same of masks.
template <int W, class T>
SIGMASWEEP_LANEWISE Mask<W, T> select_mask(Mask<W, T> mask, Mask<W, T> a, Mask<W, T> b) {
  return (mask & a) | (~mask & b);
}
template <int W, class T>
SIGMASWEEP_LANEWISE typename Vectors<W, T>::Bits bits_of(Pack<W, T> a) {
  typename Vectors<W, T>::Bits bits;
  __builtin_memcpy(&bits, &a.v, sizeof bits);
  return bits;
}
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> from_bits(typename Vectors<W, T>::Bits bits) {
  Pack<W, T> a;
  __builtin_memcpy(&a.v, &bits, sizeof bits);
  return a;
}
/// a where the mask is set, else 0.
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> where(Mask<W, T> mask, Pack<W, T> a) {
  return from_bits<W, T>(bits_of(a) & mask.v);
}
/// -a where the mask is set, else a.
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> negated_where(Mask<W, T> mask, Pack<W, T> a) {
  return from_bits<W, T>(bits_of(a) ^ (mask.v & Vectors<W, T>::sign));
}
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> magnitude(Pack<W, T> a) {
  return from_bits<W, T>(bits_of(a) & ~Vectors<W, T>::sign);
}

/// a b + c, rounded once.
SIGMASWEEP_LANEWISE double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
SIGMASWEEP_LANEWISE Vectors<2, float>::Number fused(Vectors<2, float>::Number a, Vectors<2, float>::Number b,
                                                    Vectors<2, float>::Number c) {
  for (int i = 0; i < 2; ++i) c[i] = __builtin_fmaf(a[i], b[i], c[i]);
  return c;
}
#ifdef __FMA__
SIGMASWEEP_LANEWISE __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
SIGMASWEEP_LANEWISE __m256 fused(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
#endif
#ifdef __AVX512F__
SIGMASWEEP_LANEWISE __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
SIGMASWEEP_LANEWISE __m512 fused(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
#endif
template <int W, class T>
SIGMASWEEP_LANEWISE Pack<W, T> fma(Pack<W, T> a, Pack<W, T> b, Pack<W, T> c) {
  return Pack<W, T>::of(fused(a.v, b.v, c.v));
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

/// Numbers of which two digits are enough, two for each lane: lane l has numbers l and W + l.
template <int W>
using Pairs = Pack<2 * W, float>;
template <int W>
using PairsMask = Mask<2 * W, float>;

/// The lanes' numbers, each of them twice.
SIGMASWEEP_LANEWISE Vectors<2, float>::Number twice(double a) {
  return Vectors<2, float>::Number{} + static_cast<float>(a);
}
SIGMASWEEP_LANEWISE Vectors<2, float>::Bits twice(long long a) {
  return Vectors<2, float>::Bits{} + static_cast<int>(a);
}
SIGMASWEEP_LANEWISE Vectors<8, float>::Number twice(Vectors<4>::Number a) {
  const auto narrow = __builtin_convertvector(a, Vectors<4, float>::Number);
  return __builtin_shufflevector(narrow, narrow, 0, 1, 2, 3, 0, 1, 2, 3);
}
SIGMASWEEP_LANEWISE Vectors<8, float>::Bits twice(Vectors<4>::Bits a) {
  const auto narrow = __builtin_convertvector(a, Vectors<4, float>::Bits);
  return __builtin_shufflevector(narrow, narrow, 0, 1, 2, 3, 0, 1, 2, 3);
}
#ifdef __AVX512DQ__
SIGMASWEEP_LANEWISE Vectors<16, float>::Number twice(Vectors<8>::Number a) {
  const auto narrow = __builtin_convertvector(a, Vectors<8, float>::Number);
  return __builtin_shufflevector(narrow, narrow, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
}
SIGMASWEEP_LANEWISE Vectors<16, float>::Bits twice(Vectors<8>::Bits a) {
  const auto narrow = __builtin_convertvector(a, Vectors<8, float>::Bits);
  return __builtin_shufflevector(narrow, narrow, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
}
#endif
template <int W>
SIGMASWEEP_LANEWISE Pairs<W> in_pairs(Pack<W> a) {
  return Pairs<W>::of(twice(a.v));
}
template <int W>
SIGMASWEEP_LANEWISE PairsMask<W> in_pairs(Mask<W> a) {
  return {twice(a.v)};
}

/// Whole numbers below 2^51, as such.
template <int W>
SIGMASWEEP_LANEWISE typename Vectors<W>::Bits whole_numbers(Pack<W> a) {
  const Pack<W> shift(0x1p52);  // from here on the last bit is 1
  return bits_of(a + shift) - bits_of(shift);
}

/// from[place] of each lane.
SIGMASWEEP_LANEWISE double gathered(const double* from, long long place) { return from[place]; }
#ifdef __AVX2__
SIGMASWEEP_LANEWISE __m256d gathered(const double* from, Vectors<4>::Bits places) {
  return _mm256_i64gather_pd(from, reinterpret_cast<__m256i>(places), 8);
}
#endif
#ifdef __AVX512F__
SIGMASWEEP_LANEWISE __m512d gathered(const double* from, Vectors<8>::Bits places) {
  return _mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xff, reinterpret_cast<__m512i>(places), from, 8);
}
#endif
template <int W>
SIGMASWEEP_LANEWISE Pack<W> gather(const double* from, typename Vectors<W>::Bits places) {
  return Pack<W>::of(gathered(from, places));
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
