#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "numerics/simd_pack.hpp"

/// The first root of a polynomial on (0, 1]. No root is missed.
///
/// The number of sign changes of the coefficients in the Bernstein basis of [0, 1] is an upper bound of the number of
/// roots and has the same parity (Descartes' rule in Bernstein form; e.g. Rouillier & Zimmermann, J. Comput. Appl.
/// Math. 162, 33 (2004)). Without sign changes there is no root; with one there is exactly one root, which is
/// bracketed. With more the interval is halved (de Casteljau), and the left half is searched first. Two roots closer
/// than rounding (a grazing contact) end in an interval of this width and count as one root.
namespace sigmasweep {

template <class Real, int Order>
class FirstRoot {
  static constexpr std::size_t terms = Order + 1;

 public:
  using Coefficients = std::array<Real, terms>;

  /// Smallest t in [0, limit] at which p(t) = sum p_i t^i changes from positive to negative. p must not be negative
  /// just before 0. If p_0 = 0, the sign just after 0 is that of the first coefficient that is not zero; if it is
  /// negative, the root is 0.
  static std::optional<Real> find(const Coefficients& p, const Real& limit) {
    std::size_t shift = 0;
    while (shift < terms && p[shift] == Real(0)) ++shift;
    if (shift == terms) return std::nullopt;
    if (p[shift] < 0) return Real(0);
    Coefficients q{};  // p(limit t)/t^shift
    std::copy(p.begin() + std::ptrdiff_t(shift), p.end(), q.begin());
    if (limit != Real(1)) rescale(q, limit);
    if (auto root = search(q, to_bernstein()(q), Real(0), Real(1), 0)) return *root * limit;
    return std::nullopt;
  }

 private:
  /// A lower triangular matrix, stored by columns that are divided into blocks.
  class Triangle {
   public:
    template <class Entry>
    explicit Triangle(Entry entry) {
      for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t j = i; j < terms; ++j) column_[i][j / Block::count][j % Block::count] = entry(j, i);
    }
    Coefficients operator()(const Coefficients& q) const {
      Coefficients product;
      for (std::size_t r = 0; r < blocks; ++r) {
        Block sum, other;
        const std::size_t end = std::min((r + 1) * Block::count, terms);
        std::size_t i = 0;
        for (; i + 1 < end; i += 2) {
          sum = sum + column_[i][r] * Block(q[i]);
          other = other + column_[i + 1][r] * Block(q[i + 1]);
        }
        if (i < end) sum = sum + column_[i][r] * Block(q[i]);
        sum = sum + other;
        for (std::size_t j = r * Block::count; j < end; ++j) product[j] = sum[j % Block::count];
      }
      return product;
    }

   private:
    using Block = SimdPack<Real>;
    static constexpr std::size_t blocks = (terms + Block::count - 1) / Block::count;
    std::array<std::array<Block, blocks>, terms> column_;
  };

  /// Replaces q(t) by q(scale t), in blocks so that their powers are computed independently.
  static void rescale(Coefficients& q, const Real& scale) {
    constexpr std::size_t block = 5;
    std::array<Real, block> power;
    power[0] = Real(1);
    for (std::size_t i = 1; i < block; ++i) power[i] = power[i - 1] * scale;
    const Real stride = power[block - 1] * scale;
    Real base = 1;
    for (std::size_t first = 0; first < terms; first += block, base *= stride)
      for (std::size_t i = 0; i < block && first + i < terms; ++i) q[first + i] *= base * power[i];
  }

  /// Bernstein coefficients from coefficients q: b_j = sum_{i <= j} C(j,i)/C(n,i) q_i.
  static const Triangle& to_bernstein() {
    static const Triangle map([](std::size_t j, std::size_t i) { return binomial(j, i) / binomial(Order, i); });
    return map;
  }
  /// Bernstein coefficients of the left half (de Casteljau): b_j = sum_{i <= j} C(j,i) 2^-j b_i.
  static const Triangle& to_left_half() {
    static const Triangle map([](std::size_t j, std::size_t i) {
      Real value = binomial(j, i);
      for (std::size_t k = 0; k < j; ++k) value /= 2;
      return value;
    });
    return map;
  }
  static Real binomial(std::size_t n, std::size_t k) {
    Real c = 1;
    for (std::size_t i = 1; i <= k; ++i) c = c * Real(double(n - k + i)) / Real(double(i));
    return c;
  }
  static Coefficients right_half(Coefficients b) {
    std::reverse(b.begin(), b.end());
    b = to_left_half()(b);
    std::reverse(b.begin(), b.end());
    return b;
  }

  static std::optional<Real> search(const Coefficients& q, const Coefficients& b, const Real& left, const Real& right,
                                    int depth) {
    std::uint64_t negative = 0;  // bit i is set for b_i < 0; zero counts as positive, which can only add sign changes
    for (std::size_t i = 0; i < terms; ++i) negative |= std::uint64_t(b[i] < 0) << i;
    if (negative == 0) return std::nullopt;
    if (negative & 1) return left;  // negative by rounding: the root is the start of this interval
    const std::uint64_t all = (std::uint64_t(1) << terms) - 1;
    const int changes = std::popcount((negative ^ (negative << 1)) & all);  // q starts positive
    if (changes == 1) {
      const std::size_t last_positive = std::size_t(std::countr_zero(negative)) - 1;
      // The zero of the control polygon is close to the root.
      const Real above = b[last_positive], below = b[last_positive + 1];
      const Real crossing = (Real(double(last_positive)) + above / (above - below)) / Real(Order);
      return refine(q, left, right, left + crossing * (right - left));
    }
    if (depth > max_depth) return left;
    const Real middle = (left + right) / 2;
    const Coefficients low = to_left_half()(b);
    if (auto root = search(q, low, left, middle, depth + 1)) return root;
    if (low[Order] < 0) return middle;  // the sign changed at the middle itself
    return search(q, right_half(b), middle, right, depth + 1);
  }

  /// Newton's method from t within a bracket, q(left) > 0 > q(right).
  static Real refine(const Coefficients& q, Real left, Real right, Real t) {
    if (!(t > left && t < right)) t = (left + right) / 2;
    Real previous = 0;  // the last change, or 0 if it was not a Newton step
    for (int iteration = 0; iteration < 200; ++iteration) {
      const auto [value, slope] = value_and_slope(q, t);
      if (value == Real(0)) return t;
      (value > 0 ? left : right) = t;
      const Real next = t - value / slope, change = next - t;
      const bool inside = next > left && next < right;
      // Convergence is quadratic: after the changes c' and c the next one is about c (c/c')^2.
      const Real to_come = previous == Real(0) ? change : Real(change * (change / previous) * (change / previous));
      if (magnitude(to_come) < Real(rounding) * t || magnitude(change) < Real(rounding) * t) return inside ? next : t;
      previous = inside ? change : Real(0);
      t = inside ? next : Real((left + right) / 2);
      if (t == left || t == right) return t;
    }
    return t;
  }

  struct ValueAndSlope {
    Real value, slope;
  };
  /// Horner's rule in t^2 for the even and the odd part, which the processor evaluates in parallel.
  static ValueAndSlope value_and_slope(const Coefficients& q, const Real& t) {
    const Real t2 = t * t;
    Real even = 0, odd = 0, even_slope = 0, odd_slope = 0;  // slopes with respect to t^2
    for (std::size_t i = Order / 2 + 1; i-- > 0;) {
      even_slope = even_slope * t2 + even;
      odd_slope = odd_slope * t2 + odd;
      even = even * t2 + q[2 * i];
      odd = odd * t2 + (2 * i + 1 <= Order ? q[2 * i + 1] : Real(0));
    }
    return {even + t * odd, odd + 2 * t * (even_slope + t * odd_slope)};
  }

  static constexpr int max_depth = 60;
  static constexpr double rounding = static_cast<double>(std::numeric_limits<Real>::epsilon());
  static Real magnitude(const Real& x) { return x < 0 ? Real(-x) : x; }
};

}  // namespace sigmasweep
