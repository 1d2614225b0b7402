#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

/// The first root of a polynomial on (0, 1], with a guarantee: no root is passed over.
///
/// In the Bernstein basis of [0, 1] the number of sign changes of the coefficients bounds the number of roots from
/// above and has its parity (Descartes' rule in Bernstein form; e.g. Rouillier & Zimmermann, J. Comput. Appl. Math.
/// 162, 33 (2004)). None: no root. One: exactly one, bracketed. More: halve the interval (de Casteljau), left half
/// first. Two roots closer than rounding (a grazing contact) end in an interval of that width and count as a root.
namespace sigmasweep {

template <class Real, std::size_t MaxOrder>
class FirstRoot {
 public:
  using Coefficients = std::array<Real, MaxOrder + 1>;

  /// Smallest t in [0, 1] at which p(t) = sum p_i t^i goes from positive to negative. p is known to be not negative
  /// just before 0; where p_0 = 0 the sign of the first coefficient that is not zero decides, and 0 is returned when
  /// p leaves downwards at once.
  static std::optional<Real> find(std::span<const Real> p) {
    std::size_t shift = 0;
    while (shift < p.size() && p[shift] == Real(0)) ++shift;
    if (shift == p.size()) return std::nullopt;
    if (p[shift] < 0) return Real(0);
    const std::span<const Real> q = p.subspan(shift);
    if (q.size() == 1) return std::nullopt;
    Coefficients b;
    to_bernstein(q, b);
    return search(q, b, Real(0), Real(1), 0);
  }

 private:
  /// b_j = sum_{i <= j} C(j,i)/C(n,i) q_i, by repeated addition along Pascal's triangle.
  static void to_bernstein(std::span<const Real> q, Coefficients& b) {
    const std::size_t n = q.size() - 1;
    Real binomial = 1;  // C(n, i)
    for (std::size_t i = 0; i <= n; ++i) {
      b[i] = q[i] / binomial;
      binomial = binomial * Real(static_cast<double>(n - i)) / Real(static_cast<double>(i + 1));
    }
    for (std::size_t level = 1; level <= n; ++level)
      for (std::size_t i = n; i >= level; --i) b[i] += b[i - 1];
  }

  static int sign_changes(const Coefficients& b, std::size_t n) {
    int changes = 0;
    bool negative = false;  // p starts positive
    for (std::size_t i = 0; i <= n; ++i) {
      if (b[i] == Real(0)) continue;
      if ((b[i] < 0) != negative) {
        negative = !negative;
        ++changes;
      }
    }
    return changes;
  }

  static std::optional<Real> search(std::span<const Real> q, const Coefficients& b, const Real& left,
                                    const Real& right, int depth) {
    const std::size_t n = q.size() - 1;
    const int changes = sign_changes(b, n);
    if (changes == 0) return std::nullopt;
    if (changes == 1) return refine(q, left, right);
    if (depth > max_depth) return left;
    Coefficients low, high = b;  // de Casteljau at the middle: low on the left half, high on the right half
    low[0] = high[0];
    for (std::size_t level = 1; level <= n; ++level) {
      for (std::size_t i = 0; i + level <= n; ++i) high[i] = (high[i] + high[i + 1]) / 2;
      low[level] = high[0];
    }
    const Real middle = (left + right) / 2;
    if (auto root = search(q, low, left, middle, depth + 1)) return root;
    if (low[n] < 0) return middle;  // the sign changed at the middle itself
    return search(q, high, middle, right, depth + 1);
  }

  /// Newton's method kept inside a bracket with q(left) > 0 > q(right).
  static Real refine(std::span<const Real> q, Real left, Real right) {
    Real t = (left + right) / 2;
    for (int iteration = 0; iteration < 200; ++iteration) {
      Real value = 0, slope = 0;
      for (std::size_t i = q.size(); i-- > 0;) {
        slope = slope * t + value;
        value = value * t + q[i];
      }
      if (value == Real(0)) return t;
      (value > 0 ? left : right) = t;
      Real next = t - value / slope;
      if (!(next > left && next < right)) next = (left + right) / 2;
      if (next == t || next == left || next == right) return next;
      t = next;
    }
    return t;
  }

  static constexpr int max_depth = 60;
};

}  // namespace sigmasweep
