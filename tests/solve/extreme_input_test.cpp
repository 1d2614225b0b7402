// Every corner of the parameter box gives a right answer or a status: never a hang, never a NaN that calls itself ok.
#include <gtest/gtest.h>

#include <cmath>

#include "sigmasweep/assembly/validity.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

void expect_honest(const Parameters& p) {
  ASSERT_EQ(why_invalid(p), "");
  const SimulationResult c = simulate(p);
  const auto where = [&] {
    return testing::Message() << "N " << p.N << " eps " << p.epsilon << " sigma " << p.sigma << " v0 " << p.v0 << " tc "
                              << p.tc << " method " << int(p.method) << ": status " << int(c.status);
  };
  if (is_success(c.status) || c.status == Status::tolerance_missed) {
    EXPECT_TRUE(std::isfinite(c.eps_eff) && std::isfinite(c.eps_eff_error) && std::isfinite(c.Er_Ef)) << where();
    EXPECT_TRUE(std::isfinite(c.t_k) && std::isfinite(c.x_max)) << where();
    EXPECT_GE(c.eps_eff, 0.0) << where();
    EXPECT_LE(c.eps_eff, 1.0 + c.eps_eff_error) << where();
    EXPECT_NE(c.end, End::none) << where();
  } else {
    EXPECT_TRUE(std::isnan(c.eps_eff)) << where();
  }
}

TEST(ExtremeInput, EveryCornerGivesAResultOrAStatus) {
  for (Method method : {Method::md, Method::ed})
    for (std::int64_t N : {1, 2, 3, 10, 40})
      for (double epsilon : {1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0 - 1e-12, 1.0})
        for (double s0 : {0.0, 1e-300, 1e-16, 1e-9, 1.0})
          for (double v0 : {1e-15, 1.0, 1e3})
            for (double tc : {1e-12, 1e-5, 1.0}) {
              Parameters p;
              p.method = method;
              p.N = N;
              p.epsilon = epsilon;
              p.s0 = s0;
              p.v0 = v0;
              p.tc = tc;
              p = completed(p);
              if (N == 40 && (v0 != 1.0 || tc != 1e-5)) continue;
              expect_honest(p);
            }
}

TEST(ExtremeInput, AThousandBeads) {
  for (double epsilon : {0.1, 0.5, 0.9})
    for (double sigma : {0.0, 1e-3}) {
      Parameters p;
      p.N = 1000;
      p.epsilon = epsilon;
      p.sigma = sigma;
      expect_honest(completed(p));
    }
}

}  // namespace
