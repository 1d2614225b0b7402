#include "numerics/first_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/random.hpp"

namespace {

using sigmasweep::FirstRoot, sigmasweep::Random;
constexpr int order = 24;
using Root = FirstRoot<double, order>;
using Polynomial = Root::Coefficients;

/// prod (t_i - t)/t_i, positive at 0.
Polynomial with_roots(const std::vector<double>& roots) {
  std::vector<double> p{1.0};
  const auto times = [&](double constant, double slope) {
    p.push_back(0.0);
    for (std::size_t i = p.size(); i-- > 0;) p[i] = constant * p[i] + (i > 0 ? slope * p[i - 1] : 0.0);
  };
  for (double r : roots) times(1.0, -1.0 / r);
  Polynomial q{};
  std::copy(p.begin(), p.end(), q.begin());
  return q;
}

/// By how much the smallest root moves when the coefficients change in their last digit, relative to that:
/// sum |p_i| t^i <= prod (1 + t/t_i), over |p'(t)| at the root t.
double condition(const std::vector<double>& roots) {
  const double t = roots.front();
  double size = 2.0, slope = 1.0 / t;
  for (std::size_t i = 1; i < roots.size(); ++i) {
    size *= 1.0 + t / roots[i];
    slope *= 1.0 - t / roots[i];
  }
  return size / slope;
}

TEST(FirstRoot, OfACosineIsAQuarterPeriod) {
  Polynomial p{};  // cos(2 t)
  double term = 1.0;
  for (std::size_t i = 0; i <= order; ++i) {
    if (i % 2 == 0) p[i] = i % 4 == 0 ? term : -term;
    term *= 2.0 / double(i + 1);
  }
  ASSERT_TRUE(Root::find(p, 1.0));
  EXPECT_NEAR(*Root::find(p, 1.0), std::acos(-1.0) / 4.0, 1e-15);
  EXPECT_FALSE(Root::find(p, 0.78)) << "the root lies beyond the limit";
}

TEST(FirstRoot, IsTheSmallestOfMany) {
  Random uniform(20240901);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::vector<double> roots;
    for (int i = 0; i < 1 + trial % 6; ++i) roots.push_back(0.01 + 1.5 * uniform());
    std::sort(roots.begin(), roots.end());
    bool close = false;
    for (std::size_t i = 1; i < roots.size(); ++i) close = close || roots[i] - roots[i - 1] < 1e-3;
    if (close) continue;  // the position of a nearly double root is not known to 1e-9
    const auto found = Root::find(with_roots(roots), 1.0);
    if (roots.front() > 1.0) {
      EXPECT_FALSE(found) << "trial " << trial;
    } else {
      ASSERT_TRUE(found) << "trial " << trial << ": passed over " << roots.front();
      EXPECT_NEAR(*found, roots.front(), 4e-15 * condition(roots)) << "trial " << trial;
    }
  }
}

// Two roots at a distance far below the step: what sampling would miss.
TEST(FirstRoot, FindsAPairOfRootsThatAlmostTouch) {
  for (double distance : {1e-2, 1e-4, 1e-6})
    for (double at : {0.1, 1.0 / 3.0, 0.5, 0.77}) {
      const auto found = Root::find(with_roots({at, at + distance}), 1.0);
      ASSERT_TRUE(found) << at << " " << distance;
      EXPECT_NEAR(*found, at, 1e-15 / distance + 1e-14) << at << " " << distance;
    }
}

// A root on a point of bisection, beside complex pairs that force the halving.
TEST(FirstRoot, OnABisectionPoint) {
  Random uniform(3);
  for (int trial = 0; trial < 200'000; ++trial) {
    const int level = 1 + int(uniform.bits() % 4);
    const double root = (1.0 + double(uniform.bits() % ((1u << level) - 1))) / double(1u << level);
    Polynomial p = with_roots({root});
    for (int pair = 0; pair < 3; ++pair) {  // times ((t - a)^2 + b^2)/(a^2 + b^2)
      const double a = uniform(), b = 0.02 + 0.3 * uniform(), norm = a * a + b * b;
      Polynomial q{};
      for (std::size_t i = 0; i <= order; ++i)
        q[i] = p[i] + (i > 0 ? -2.0 * a / norm * p[i - 1] : 0.0) + (i > 1 ? p[i - 2] / norm : 0.0);
      p = q;
    }
    const auto found = Root::find(p, 1.0);
    ASSERT_TRUE(found) << trial;
    ASSERT_NEAR(*found, root, 1e-6) << trial;  // pairs of 0.02 beside the root: condition up to 1e9
  }
}

TEST(FirstRoot, ADipThatStaysPositiveIsNoRoot) {
  Polynomial p{};  // (t - 1/2)^2 + 1e-12
  p[0] = 0.25 + 1e-12;
  p[1] = -1.0;
  p[2] = 1.0;
  EXPECT_FALSE(Root::find(p, 1.0));
}

TEST(FirstRoot, AfterAnEventTheZeroAtTheStartDoesNotCount) {
  Polynomial p{};  // t (1 - 2t)
  p[1] = 1.0;
  p[2] = -2.0;
  ASSERT_TRUE(Root::find(p, 1.0));
  EXPECT_NEAR(*Root::find(p, 1.0), 0.5, 1e-15);
  p[1] = -1.0;  // leaves downwards at once
  ASSERT_TRUE(Root::find(p, 1.0));
  EXPECT_EQ(*Root::find(p, 1.0), 0.0);
  EXPECT_FALSE(Root::find(Polynomial{}, 1.0)) << "a contact at rest stays as it is";
}

}  // namespace
