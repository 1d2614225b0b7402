#include "sigmasweep/solve/cost.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sigmasweep/model/names.hpp"

using namespace sigmasweep;

namespace {

Parameters with(std::int64_t N, double sigma, Method method, Integrator integrator, double steps = 100.0) {
  Parameters p;
  p.N = N;
  p.sigma = sigma;
  p.method = method;
  p.integrator = integrator;
  p.steps_per_tc = steps;
  return p;
}

}  // namespace

TEST(Cost, IsPositiveAndFiniteAtTheExtremes) {
  for (const auto method : {Method::md, Method::ed})
    for (const auto integrator : values_of<Integrator>())
      for (const std::int64_t N : {std::int64_t{1}, std::int64_t{1000000}})
        for (const double sigma : {0.0, 5e-324, 1.0, 1.7976931348623157e308})
          for (const double epsilon : {5e-324, 1.0}) {
            Parameters p = with(N, sigma, method, integrator, 1e6);
            p.epsilon = epsilon;
            const double time = predicted_time(p);
            EXPECT_TRUE(std::isfinite(time) && time > 0.0) << time;
          }
}

TEST(Cost, GrowsWithBeadsAndSteps) {
  for (const auto integrator : {Integrator::exact, Integrator::gear5})
    for (const double sigma : {0.0, 0.3, 3.0, 1e4}) {
      double before = 0.0;
      for (std::int64_t N = 1; N <= 1000000; N *= 3) {
        const double time = predicted_time(with(N, sigma, Method::md, integrator));
        EXPECT_GT(time, before) << N;
        before = time;
      }
    }
  EXPECT_GT(predicted_time(with(10, 1.0, Method::md, Integrator::gear5, 200)),
            predicted_time(with(10, 1.0, Method::md, Integrator::gear5, 100)));
  EXPECT_GT(predicted_time(with(20, 1.0, Method::ed, Integrator::exact)),
            predicted_time(with(10, 1.0, Method::ed, Integrator::exact)));
}

TEST(Cost, GrowsWithWhatIsHarder) {
  const Parameters plain = with(10, 1.0, Method::md, Integrator::exact);
  Parameters nonlinear = plain, uneven = plain;
  nonlinear.law = Law::hertz;
  uneven.width = 1e-4;
  EXPECT_GT(predicted_time(nonlinear), predicted_time(plain));
  EXPECT_GT(predicted_time(uneven), predicted_time(plain));
  const Parameters hard = with(10, 1.0, Method::ed, Integrator::exact);
  Parameters tc_rule = hard, hard_hertz = hard;
  tc_rule.ed_rule = EdRule::tc;
  hard_hertz.law = Law::hertz;
  EXPECT_GT(predicted_time(tc_rule), predicted_time(hard));
  EXPECT_EQ(predicted_time(hard_hertz), predicted_time(hard));
}

TEST(Cost, OfRowsThatAreNoneIsANumberToo) {
  Parameters p = with(10, std::nan(""), Method::md, Integrator::exact);
  p.epsilon = std::nan("");
  EXPECT_TRUE(std::isfinite(predicted_time(p)));
}
