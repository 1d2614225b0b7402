// What holds for every collision, at the ends of the parameters: energy and momentum, reversal, scaling, order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "assembly/energies.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/observer/samples.hpp"
#include "support/parameters.hpp"

namespace {

using namespace sigmasweep;

Parameters tuple(std::int64_t N, double epsilon, double sigma, double width = 0.0) {
  // SI and reduced units are the same
  return soft_column(
      {.v0 = 1.0, .tc = 1.0, .sigma = sigma, .epsilon = epsilon, .width = width * Parameters{}.d, .N = N});
}

/// Energy, momentum, and what dashpots and the wall have done up to each sample of a recorded collision: the books kept
/// from the film alone, by the trapezoidal rule.
struct Books {
  std::vector<double> energy, momentum, dashpot_work, wall_impulse;
};

Books books_of(const Parameters& p, double duration, std::size_t samples) {
  const Column<double> column = reduced_column<double>(p);
  const Trajectory film = record(p, sample_times(duration, samples));
  const auto [beta, gamma] = column.exponents;
  Books books;
  double work = 0.0, impulse = 0.0, last_power = 0.0, last_force = 0.0;
  for (std::size_t s = 0; s < samples; ++s) {
    double energy = 0.0, momentum = 0.0, power = 0.0, wall_force = 0.0;
    for (std::size_t i = 0; i < film.beads(); ++i) {
      const std::size_t here = s * film.beads() + i;
      const double v = film.velocity[here], m = film.mass[i];
      const double x = (i > 0 ? film.z[here - 1] : 0.0) - film.z[here];
      const double u = (i > 0 ? film.velocity[here - 1] : 0.0) - v;
      energy += 0.5 * m * v * v;
      momentum += m * v;
      if (!(x > 0.0)) continue;
      energy += column.spring(i) * std::pow(x, 2.0 + beta) / (2.0 + beta);
      const double damping = column.dashpot(i) * std::pow(x, gamma) * u;
      power += damping * u;
      if (i == 0) wall_force = column.spring(0) * std::pow(x, 1.0 + beta) + damping;
    }
    const double dt = s > 0 ? film.time[s] - film.time[s - 1] : 0.0;
    books.dashpot_work.push_back(work += 0.5 * dt * (power + last_power));
    books.wall_impulse.push_back(impulse += 0.5 * dt * (wall_force + last_force));
    books.energy.push_back(energy);
    books.momentum.push_back(momentum);
    last_power = power;
    last_force = wall_force;
  }
  return books;
}

double largest_imbalance(const std::vector<double>& stored, const std::vector<double>& fed) {
  double largest = 0.0;
  for (std::size_t s = 0; s < stored.size(); ++s)
    largest = std::max(largest, std::fabs(stored[s] - stored[0] - fed[s]));
  return largest;
}

void expect_balance(const Parameters& p) {
  SCOPED_TRACE(testing::Message() << "law " << int(p.law) << " N " << p.N << " eps " << p.epsilon << " sigma "
                                  << p.sigma << " width " << p.width << " D_n " << p.D_n);
  const SimulationResult c = simulate(p);
  ASSERT_EQ(c.status, Status::ok);
  const double duration = std::min(1.2 * (p.sigma + c.t_k) + 0.1, 40.0);
  const double N = static_cast<double>(p.N);
  // The rule's own error is of first order, from the jumps of the integrand within a step, and erratic: 16 times the
  // steps leave about 1/16 of the imbalance, and must leave less than half.
  double last = 0.0;
  for (const std::size_t samples : {4001u, 64001u}) {
    Books books = books_of(p, duration, samples);
    for (std::size_t s = 1; s < samples; ++s)
      ASSERT_LE(books.energy[s], books.energy[s - 1] + 1e-10 * N) << "energy rises at sample " << s;
    for (double& work : books.dashpot_work) work = -work;
    const double imbalance = largest_imbalance(books.energy, books.dashpot_work);
    const double momentum = largest_imbalance(books.momentum, books.wall_impulse);
    const double fine = samples > 10000 ? std::max(0.5 * last, 1e-9 * N) : 3e-2 * N;
    EXPECT_LE(std::max(imbalance, momentum), fine) << samples;
    last = std::max(imbalance, momentum);
  }
}

TEST(Extreme, EnergyGoesIntoTheDashpotsAndMomentumComesFromTheWall) {
  for (const double epsilon : {1.0, 1.0 - 1e-12, 0.9, 0.5, 0.1, 1e-3, 1e-6})
    for (const std::int64_t N : {1, 2, 3, 10})
      for (const double sigma : {0.0, 0.3, 2.0}) expect_balance(tuple(N, epsilon, sigma));
}

TEST(Extreme, TheBooksBalanceForUnequalBeadsAndOtherLaws) {
  for (const double width : {0.5, 1.9}) expect_balance(tuple(4, 0.7, 0.2, width));
  for (const Law law : {Law::hertz, Law::hertz_kuwabara_kono, Law::taguchi})
    for (const double epsilon : {1.0, 0.8, 0.3}) {
      Parameters p = tuple(4, epsilon, 0.2);
      p.law = law;
      expect_balance(p);
    }
}

TEST(Extreme, TheBooksBalanceForOverdampedPairs) {
  for (const double damping : {1.0, 2.0, 5.0}) {
    Parameters p{.v0 = 1.0, .s0 = 0.1, .K_over_m = 9.8696044010893586, .D_n = damping * 3.14159265358979323846, .N = 4};
    expect_balance(completed(p));  // tc = 1
  }
}

TEST(Extreme, WithoutDashpotsNothingIsLost) {
  for (const std::int64_t N : {1, 2, 3, 10, 100})
    for (const double sigma : {0.0, 1e-300, 1e-16, 1e-12, 1e-3, 0.5, 1.0, 3.0, 1e6, 1e12})
      for (const double width : {0.0, 1.99}) {
        if (width > 0.0 && N > 10) continue;  // chaotic, some of them
        const SimulationResult c = simulate(tuple(N, 1.0, sigma, width));
        ASSERT_TRUE(c.status == Status::ok) << N << " " << sigma << " " << width << " status " << int(c.status);
        EXPECT_NEAR(c.eps_eff, 1.0, std::min(1e-10, c.eps_eff_error)) << N << " " << sigma << " " << width;
      }
}

/// Forward for `duration`, all velocities reversed, and on to the end: the velocities then.
std::vector<double> there_and_back(const Column<double>& column, double duration) {
  Samples samples({duration}, column.contacts());
  observe_exact(column, samples);
  Column<double> back = column;
  back.gaps.clear();
  std::vector<double> rates;
  for (std::size_t k = 0; k < column.contacts(); ++k) {
    back.gaps.push_back(-samples.x(0)[k]);
    rates.push_back(-samples.u(0)[k]);
  }
  RunLimits to_the_end;
  to_the_end.settle = 0.0;
  const auto outcome = exact_collision_from<double>(back, rates, to_the_end);
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_EQ(outcome.end, End::separated);
  return outcome.velocity;
}

// Elastic columns run back to where they came from: all beads at +v0. An error grows on the way there and back as it
// does in a collision; for these columns by less than 1e4.
TEST(Extreme, ElasticColumnsRunBackToTheirStart) {
  for (const std::int64_t N : {1, 2, 3, 5, 10})
    for (const double sigma : {1e-16, 1e-9, 0.01, 0.3, 1.0, 4.0}) {
      const auto column = reduced_column<double>(tuple(N, 1.0, sigma));
      const Outcome<double> end = exact_collision(column, {.settle = 0.0});
      ASSERT_EQ(end.end, End::separated);
      for (const double v : there_and_back(column, 2.0 * end.t_k + 10.0 * (1.0 + sigma)))
        EXPECT_NEAR(v, 1.0, 1e-11) << N << " " << sigma;
    }
}

TEST(Extreme, UnequalElasticColumnsRunBackToTheirStart) {
  for (const double width : {0.3, 1.5, 1.99})
    for (const double sigma : {1e-9, 0.3, 4.0}) {
      const auto column = reduced_column<double>(tuple(5, 1.0, sigma, width));
      const Outcome<double> end = exact_collision(column, {.settle = 0.0});
      ASSERT_EQ(end.end, End::separated);
      const auto velocity = there_and_back(column, 2.0 * end.t_k + 10.0 * (1.0 + sigma));
      for (std::size_t i = 0; i < velocity.size(); ++i)  // weighted as the energy is: light beads shake most
        EXPECT_NEAR(velocity[i], 1.0, 1e-9 / std::sqrt(column.mass[i])) << width << " " << sigma << " bead " << i;
    }
}

// Two springs in a row: with contact k passing at zero speed (u = 0 at x = 0) the first to touch at all.
TEST(Extreme, GrazingContactsChangeNothing) {
  for (const double epsilon : {1.0, 0.9, 0.3})
    for (const std::int64_t N : {2, 3, 5}) {
      const auto at = [&](double sigma) { return simulate(tuple(N, epsilon, sigma)); };
      // The gap at which the bead that comes back from the wall just misses contact in the shared motion: bisect the
      // number of contacts. On both sides eps_eff is the same but for the condition of the problem.
      double low = 0.0, high = 3.0;
      const std::uint64_t few = at(low).contacts;
      if (at(high).contacts == few) continue;
      while (high - low > 4e-16 * high) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (at(middle).contacts == few ? low : high) = middle;
      }
      const SimulationResult a = at(low), b = at(high);
      ASSERT_EQ(a.status, Status::ok);
      ASSERT_EQ(b.status, Status::ok);
      EXPECT_NEAR(a.eps_eff, b.eps_eff, a.eps_eff_error + b.eps_eff_error + 1e-11) << epsilon << " " << N;
    }
}

// Powers of two change no digit of sigma, so no digit of the result.
TEST(Extreme, OnlySigmaCounts) {
  for (const double epsilon : {1.0, 0.9, 1e-3})
    for (const double sigma : {0.0, 1e-12, 0.7, 1e12}) {
      const SimulationResult expected = simulate(tuple(5, epsilon, sigma));
      for (const double scale : {0x1p-30, 0x1p-10, 0x1p30}) {
        Parameters p = tuple(5, epsilon, sigma);
        p.v0 *= scale;
        p.tc *= scale * scale;
        p.d *= 3.0;
        const SimulationResult c = simulate(completed(p));
        EXPECT_EQ(c.eps_eff, expected.eps_eff);
        EXPECT_EQ(c.contacts, expected.contacts);
        EXPECT_EQ(c.t_k, expected.t_k * scale * scale);
        EXPECT_EQ(c.x_max, expected.x_max * scale * scale * scale);
      }
    }
}

// Stiffness and damping given directly: only D_n/sqrt(K_over_m) and sigma count.
TEST(Extreme, OnlyTheDampingRatioCountsOverEighteenDecadesOfSpeed) {
  for (const double damping : {0.3, 1.0, 2.0}) {
    double expected = 0.0;
    for (int decade = -15; decade <= 3; decade += 3) {
      Parameters p{.v0 = std::pow(10.0, decade), .sigma = 0.2, .K_over_m = 4e10, .D_n = damping * 2e5, .N = 6};
      const SimulationResult c = simulate(completed(p));
      ASSERT_EQ(c.status, Status::ok);
      if (decade == -15) expected = c.eps_eff;
      EXPECT_NEAR(c.eps_eff, expected, 1e-12);
    }
  }
}

// SI units or reduced ones, long double's plain loops or double's vectors: the same physics.
TEST(Extreme, UnitsAndLanesAreTheSame) {
  for (const double epsilon : {1.0, 0.9, 0.5, 0.1})
    for (const std::int64_t N : {7, 8, 9, 17})
      for (const double sigma : {0.0, 1e-9, 0.2}) {
        Parameters p = tuple(N, epsilon, sigma);
        p.v0 = 3e-4;
        p.tc = 7e-6;
        p = completed(p);
        const auto value = [](const auto& column, auto real) {
          using Real = decltype(real);
          return double(energies<Real>(exact_collision(column).velocity, column.speed, column.mass).eps_eff);
        };
        const double expected = value(reduced_column<double>(p), 0.0);
        const double bar = simulate(p).eps_eff_error;
        EXPECT_NEAR(value(si_column<double>(p), 0.0), expected, 2 * bar + 1e-13) << N << " " << epsilon << " " << sigma;
        EXPECT_NEAR(value(reduced_column<long double>(p), 0.0L), expected, bar + 1e-13)
            << N << " " << epsilon << " " << sigma;
      }
}

TEST(Extreme, TheOrderOfTuplesDoesNotMatter) {
  std::vector<Parameters> tuples;
  for (const Law law : {Law::hooke, Law::hertz})
    for (const Method method : {Method::md, Method::ed})
      for (const std::int64_t N : {1, 4, 12})
        for (const double sigma : {0.0, 0.4, 50.0}) {
          Parameters p = tuple(N, 0.8, sigma);
          p.method = method;
          p.law = method == Method::md ? law : Law::hooke;
          tuples.push_back(p);
        }
  std::vector<double> forwards, backwards;
  for (const Parameters& p : tuples) forwards.push_back(simulate(p).eps_eff);
  std::reverse(tuples.begin(), tuples.end());
  for (const Parameters& p : tuples) backwards.push_back(simulate(p).eps_eff);
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(forwards, backwards);
}

}  // namespace
