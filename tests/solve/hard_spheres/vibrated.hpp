#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "solve/hard_spheres/vibrated_column.hpp"
#include "support/parameters.hpp"

/// What tests of hard spheres on a vibrating plate share. Natural units: 1/omega and g/omega^2.
namespace sigmasweep {

using std::numbers::pi;
inline constexpr double turn = 2.0 * pi;

inline Parameters vibrated(std::int64_t N, double epsilon, double alpha, std::int64_t periods = 40,
                           std::int64_t transient = 10) {
  return vibrated_column(
      {.epsilon = epsilon, .alpha = alpha, .periods = periods, .transient = transient, .N = N, .method = Method::ed});
}

/// Of parameters that may have been changed since they were completed.
inline SimulationResult run(const Parameters& p) {
  const SimulationResult c = simulate_vibrated_hard_spheres(vibrated_column(p));
  if (is_success(c.status)) {
    EXPECT_EQ(c.end, End::periods);
    EXPECT_TRUE(std::isfinite(c.vibration.h_cm));
  }
  return c;
}

inline double unit_length(const Parameters& p) { return p.gravity / (turn * p.frequency * turn * p.frequency); }
inline double excess(const Parameters& p, const SimulationResult& c) {
  return c.vibration.h_cm_excess / unit_length(p);
}

/// Sees where the beads are, ten times a period.
struct Film {
  static constexpr int samples = 10;
  std::size_t N;
  double alpha;
  int periods, period = 0, taken = 0;
  std::vector<double> x = std::vector<double>(N), u = x;
  std::vector<std::vector<double>> z{};  ///< sample by sample

  static double moment(int sample) { return turn * (sample + 0.5) / samples; }
  template <class State>
  void until(double time, State&& state) {
    for (; taken < samples && moment(taken) <= time; ++taken) {
      state(moment(taken), std::span(x), std::span(u));
      double height = alpha * std::sin(moment(taken));
      z.emplace_back();
      for (const double overlap : x) z.back().push_back(height -= overlap);
    }
  }
  void end_period(double, double, double) {
    ++period;
    taken = 0;
  }
  bool done() const { return period == periods; }
};

inline Column<double> column(const std::vector<double>& gaps, double e, double e_wall) {
  Column<double> c;
  c.N = static_cast<std::int64_t>(gaps.size());
  c.eps = e;
  c.eps_wall = e_wall;
  c.gaps = gaps;
  return c;
}

}  // namespace sigmasweep
