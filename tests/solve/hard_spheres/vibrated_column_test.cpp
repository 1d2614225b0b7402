#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/names.hpp"
#include "solve/hard_spheres/vibrated.hpp"
#include "solve/hard_spheres/vibrated_column.hpp"
#include "solve/plain_vibrated.hpp"

/// Hard spheres on a vibrating plate.
namespace sigmasweep {
namespace {

/// The same by plain_vibrated.hpp, as long as its own answer to eps, and with it each collision, changed by a rounding
/// is below 1e-7: these motions are chaotic. Of bounces that get ever shorter the plain program follows the first
/// `most`.
void compare_with_plain(double alpha, double e, double e_wall, const std::vector<double>& gaps, std::uint64_t fewest,
                        std::uint64_t most) {
  Film film{.N = gaps.size(), .alpha = alpha, .periods = 20};
  VibratedHardSpheres spheres(column(gaps, e, e_wall), Plate{1.0, alpha, 1.0}, {});
  spheres.run(film);
  const double nudge = 1.0 + 8.0 * std::numeric_limits<double>::epsilon();
  plain_vibrated::Plain plain(alpha, e, e_wall, gaps), twin(alpha, e * nudge, e_wall * nudge, gaps);
  double doubt = 1e-14 * alpha;
  for (int sample = 0; sample < static_cast<int>(film.z.size()) && doubt < 1e-7; ++sample) {
    const plain_vibrated::Long t = turn * (sample / Film::samples) + Film::moment(sample % Film::samples);
    for (plain_vibrated::Plain* p : {&plain, &twin})
      while (p->now < t && p->collisions < most) p->advance(t);
    if (plain.now < t || twin.now < t) break;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      doubt = std::max(doubt, 10.0 * static_cast<double>(std::fabs(plain.z[i] - twin.z[i])));
      ASSERT_NEAR(film.z[std::size_t(sample)][i], static_cast<double>(plain.z[i]), doubt)
          << "bead " << i << " sample " << sample << " after " << plain.collisions << " collisions";
    }
  }
  EXPECT_GE(plain.collisions, fewest);
}

TEST(PlainProgram, AgreesForOneBall) {
  compare_with_plain(2.0, 0.9, 0.9, {0.5}, 10, 60);
  compare_with_plain(5.0, 0.5, 0.5, {0.5}, 10, 15);
  compare_with_plain(0.5, 0.9, 0.9, {3.0}, 15, 60);
  compare_with_plain(30.0, 0.6, 0.6, {0.01}, 3, 20);
}

TEST(PlainProgram, AgreesForColumns) {
  compare_with_plain(5.0, 0.9, 0.8, {0.5, 0.3}, 15, 60);
  compare_with_plain(3.0, 0.92, 0.95, {0.1, 0.23, 0.37, 0.11, 0.29}, 60, 200);
  compare_with_plain(15.0, 0.7, 0.8, {1.0, 0.5, 0.25, 2.0}, 30, 100);
}

/// Sees the gap between one bead and the plate at two moments of the first period.
struct Gaps {
  std::vector<double> moments, seen{};
  bool over = false;
  template <class State>
  void until(double time, State&& state) {
    for (double x = 0.0, u = 0.0; seen.size() < moments.size() && moments[seen.size()] <= time; seen.push_back(-x))
      state(moments[seen.size()], std::span(&x, 1), std::span(&u, 1));
  }
  void end_period(double, double, double) { over = true; }
  bool done() const { return over; }
};

TEST(Rest, ComesAfterInfinitelyManyBounces) {
  // Dropped from s onto a plate at rest: sqrt(2 s) (1 + 2 (e + e^2 + ...)), 5 here.
  for (const double e : {0.1, 0.5, 0.9}) {
    const double early = 1e-5, s = 0.5 * std::pow(5.0 * (1.0 - e) / (1.0 + e), 2);
    Gaps watcher{{5.0 - early, 5.0 + 1e-12}};
    VibratedHardSpheres(column({s}, e, e), Plate{1.0, 0.0, 1.0}, {}).run(watcher);
    ASSERT_EQ(watcher.seen.size(), 2u);
    const double flight = early * (1.0 - e) / e;  // at most, as the later ones are over in time: e/(1 - e) of it
    EXPECT_GT(watcher.seen[0], 0.0) << e;
    EXPECT_LE(watcher.seen[0], flight * flight / 8) << e;
    EXPECT_EQ(watcher.seen[1], 0.0) << e;
  }
}

TEST(Rest, StaysOnASlowPlate) {
  for (const std::int64_t N : {1, 2, 10, 100})
    for (const double alpha : {0.0, 0.3, 0.999999, 1.0})
      for (const double epsilon : {0.1, 0.9, 1.0}) {
        const Parameters p = vibrated(N, epsilon, alpha);
        const SimulationResult c = run(p);
        EXPECT_EQ(c.status, Status::ok);
        EXPECT_EQ(c.contacts, 0u);
        EXPECT_NEAR(excess(p, c), 0.0, 1e-15);
        EXPECT_EQ(c.vibration.E_r, 0.0);
        EXPECT_EQ(c.vibration.power_lost, 0.0);
        EXPECT_EQ(c.vibration.power_in, 0.0);
        EXPECT_FALSE(c.vibration.separation_max > 0.0);
      }
  Parameters p = vibrated(10, 0.9, 0.7, 200, 100);  // after a fall and what comes of it
  p.s0 = 1e-4;
  const SimulationResult c = run(p);
  EXPECT_EQ(c.status, Status::collapsed);
  EXPECT_NEAR(excess(p, c), 0.0, 1e-15);
  EXPECT_EQ(c.vibration.separation_max, 0.0);
}

/// The reference values of other programs: N = 10, eps = 0.92, f = 20 Hz, 20,000 periods; h_cm - h_cm0 in m.
struct Reference {
  double alpha;
  Wall wall;
  double h_cm_excess, error;
};

class References : public testing::TestWithParam<Reference> {};

TEST_P(References, AreReproduced) {
  const Reference& r = GetParam();
  Parameters p = vibrated(10, 0.92, r.alpha, 10'000, 500);
  p.wall = r.wall;
  const SimulationResult c = run(p);
  EXPECT_NEAR(c.vibration.h_cm_excess, r.h_cm_excess, 4.0 * std::hypot(r.error, c.vibration.h_cm_error));
  EXPECT_LT(c.vibration.h_cm_error, 0.02 * r.h_cm_excess);
}

INSTANTIATE_TEST_SUITE_P(
    Figure7, References,
    testing::Values(
        Reference{3, Wall::matched, 7.224849e-03, 1.2e-05}, Reference{3, Wall::paper, 7.358990e-03, 1.0e-05},
        Reference{5, Wall::matched, 2.006607e-02, 8.0e-05}, Reference{5, Wall::paper, 2.102713e-02, 6.4e-05},
        Reference{6, Wall::matched, 2.853826e-02, 1.5e-04}, Reference{6, Wall::paper, 3.076509e-02, 1.3e-04},
        Reference{10, Wall::matched, 8.134280e-02, 3.6e-04}, Reference{10, Wall::paper, 8.540359e-02, 3.9e-04},
        Reference{12, Wall::matched, 1.182436e-01, 6.5e-04}, Reference{12, Wall::paper, 1.221946e-01, 6.3e-04},
        Reference{18, Wall::matched, 2.646667e-01, 1.9e-03}, Reference{18, Wall::paper, 2.806245e-01, 1.8e-03}),
    [](const auto& run) {
      return "alpha" + std::to_string(std::lround(run.param.alpha)) + "_" + std::string(name_of(run.param.wall));
    });

// The plate's work and the losses are summed collision by collision; the energy at a period's end comes from the state.
// Each collision rounds the momentum of all beads above it.
TEST(Books, Balance) {
  for (const std::int64_t N : {1, 3, 20})
    for (const double epsilon : {0.3, 0.6, 0.9})
      for (const double alpha : {1.5, 2.5, 40.0})
        for (const double width : {0.0, 0.5e-3})
          for (const EdRule rule : {EdRule::lrv, EdRule::tc}) {
            Parameters p = vibrated(N, epsilon, alpha, 12, 2);
            p.s0 = 1e-4;
            p.random_separation = Flag::yes;
            p.width = width;
            p.ed_rule = rule;
            p.tc = 1e-3;
            const SimulationResult c = run(p);
            ASSERT_TRUE(is_success(c.status)) << name_of(c.status);
            const double rounding = std::numeric_limits<double>::epsilon() * (100.0 + static_cast<double>(c.contacts));
            EXPECT_LT(std::fabs(c.vibration.imbalance), rounding)
                << "N=" << N << " eps=" << epsilon << " alpha=" << alpha << " width=" << width << name_of(rule);
          }
}

TEST(Books, ElasticBeadsLoseNothing) {
  for (const std::int64_t N : {1, 2, 10}) {
    const SimulationResult c = run(vibrated(N, 1.0, 3.0, 300));
    EXPECT_EQ(c.status, Status::ok);
    EXPECT_EQ(c.vibration.power_lost, 0.0);
    EXPECT_GT(c.vibration.power_in, 0.0);
    EXPECT_LT(std::fabs(c.vibration.imbalance), 1e-12);
  }
}

TEST(Scaling, OnlyReducedParametersCount) {
  Parameters p = vibrated(6, 0.9, 4.0, 3, 0);
  p.s0 = 2e-4;
  p.random_separation = Flag::yes;
  const SimulationResult c = run(p);
  const auto scaled = [&](double f, double g) {
    Parameters q = p;
    q.frequency *= f;
    q.gravity *= g;
    q.s0 *= g / (f * f);
    q.A0 *= g / (f * f);
    return q;
  };
  const Parameters exact = scaled(2.0, 4.0), rounded = scaled(3.7, 0.165);
  EXPECT_EQ(excess(exact, run(exact)), excess(p, c));
  // Two dozen collisions may make a thousand times more of a rounding.
  EXPECT_NEAR(excess(rounded, run(rounded)), excess(p, c), 1e-12 * excess(p, c));
  EXPECT_EQ(run(rounded).contacts, c.contacts);
}

TEST(Extremes, EndWithAResult) {
  for (const std::int64_t N : {1, 2, 100})
    for (const double alpha : {1.001, 100.0})
      for (const double frequency : {0.1, 1e4})
        for (const double epsilon : {1e-6, 0.1, 0.9, 1.0}) {
          if (epsilon >= 0.9 && N == 100 && alpha < 2.0) continue;  // ten thousands of collisions a period
          const SimulationResult c = run({.epsilon = epsilon,
                                          .frequency = frequency,
                                          .alpha = alpha,
                                          .periods = 20,
                                          .transient = 10,
                                          .N = N,
                                          .method = Method::ed});
          EXPECT_TRUE(is_success(c.status)) << N << " " << alpha << " " << epsilon << " " << name_of(c.status);
        }
  EXPECT_TRUE(is_success(run(vibrated(10, 0.92, 100.0, 10'000)).status));
  EXPECT_TRUE(is_success(run(vibrated(1, 1.0, 100.0, 10'000)).status));
}

TEST(Extremes, TcModelBouncesOnUntilTheLimit) {
  Parameters p = vibrated(1, 0.5, 0.0, 3, 0);
  p.s0 = 1e-3;
  p.ed_rule = EdRule::tc;
  p.tc = 1e-4;
  const SimulationResult c = run(p);  // bounces of a duration of tc, from when they are that short
  EXPECT_EQ(c.status, Status::ok);
  EXPECT_GT(static_cast<double>(c.contacts), 0.5 * 3 / (p.frequency * p.tc));
  EXPECT_LT(static_cast<double>(c.contacts), 10.0 * 3 / (p.frequency * p.tc));
}

TEST(GivingUp, IsAStatus) {
  Film film{.N = 3, .alpha = 3.0, .periods = 20};
  VibratedHardSpheres few(column({0.1, 0.2, 0.3}, 0.9, 0.9), Plate{1.0, 3.0, 1.0}, {}, {.event_limit = 10});
  few.run(film);
  EXPECT_EQ(few.status(), Status::event_limit);
  EXPECT_EQ(few.collisions(), 10u);
  Film again{.N = 3, .alpha = 3.0, .periods = 20};
  VibratedHardSpheres slow(column({0.1, 0.2, 0.3}, 0.9, 0.9), Plate{1.0, 3.0, 1.0}, {.period_limit = 5});
  slow.run(again);
  EXPECT_EQ(slow.status(), Status::event_limit);
  ComputeBudget none(0.0);
  const SimulationResult c = simulate_vibrated_hard_spheres(vibrated(10, 0.92, 3.0, 1'000'000), &none);
  EXPECT_EQ(c.status, Status::time_limit);
  EXPECT_TRUE(std::isnan(c.vibration.h_cm));
}

}  // namespace
}  // namespace sigmasweep
