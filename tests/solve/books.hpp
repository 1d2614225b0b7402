#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "solve/exact/linear/collision.hpp"
#include "solve/exact/power_law/collision.hpp"
#include "solve/hard_spheres/collision.hpp"
#include "solve/observer/samples.hpp"

/// The books of a collision, kept from its film alone: energy and momentum, and what dashpots and the wall have done
/// meanwhile, by adaptive quadrature (Lobatto's five points against twice five, halved until they agree). That settles
/// kinks, where contacts open and close, as well as fast motions.
namespace sigmasweep::books {

/// At the ends of the intervals that the duration was divided into.
struct Books {
  std::vector<double> energy, momentum;            ///< elastic energy included
  std::vector<double> dashpot_work, wall_impulse;  ///< so far

  /// Largest difference between what is there and what came and went.
  double energy_imbalance() const { return imbalance(energy, dashpot_work, 1.0); }
  double momentum_imbalance() const { return imbalance(momentum, wall_impulse, -1.0); }
  double largest_rise_of_energy() const {
    double largest = 0.0;
    for (std::size_t j = 1; j < energy.size(); ++j) largest = larger(largest, energy[j] - energy[j - 1]);
    return largest;
  }

 private:
  static double larger(double a, double b) { return b <= a ? a : b; }  // NaN comes through
  static double imbalance(const std::vector<double>& stock, const std::vector<double>& flow, double sign) {
    double largest = 0.0;
    for (std::size_t j = 0; j < stock.size(); ++j)
      largest = larger(largest, std::fabs(stock[j] - stock[0] + sign * flow[j]));
    return largest;
  }
};

/// `watch(column, samples)`: one of the solvers' runs with a watcher (samples.hpp), the same run whatever the samples.
template <class Watch>
class Accounts {
 public:
  Accounts(const Column<double>& column, Watch watch) : column_(column), watch_(watch) {}

  Books operator()(double duration, std::size_t intervals) {
    Books books;
    std::vector<double> ends;
    for (std::size_t j = 0; j <= intervals; ++j) ends.push_back(duration * double(j) / double(intervals));
    film(ends, [&](auto x, auto u) {
      const State state = at(x, u);
      books.energy.push_back(state.energy);
      books.momentum.push_back(state.momentum);
    });
    std::vector<Flow> flows(intervals);
    std::vector<Piece> pieces;
    for (std::size_t j = 0; j < intervals; ++j) pieces.push_back({j, ends[j], ends[j + 1], {}});
    integrate(pieces);
    while (!pieces.empty()) pieces = refined(pieces, flows);
    Flow sum;
    books.dashpot_work.push_back(0.0);
    books.wall_impulse.push_back(0.0);
    for (const Flow& flow : flows) {
      sum += flow;
      books.dashpot_work.push_back(sum.work);
      books.wall_impulse.push_back(sum.impulse);
    }
    return books;
  }

 private:
  static constexpr double agreed = 1e-15;  ///< of a piece's whole and its halves
  /// On [0, 1]. The ends are among them: a contact that opens just behind one is seen.
  static constexpr double nodes[]{0.0, 0.17267316464601143, 0.5, 0.82732683535398857, 1.0};
  static constexpr double weights[]{1.0 / 20, 49.0 / 180, 16.0 / 45, 49.0 / 180, 1.0 / 20};
  static constexpr std::size_t points = std::size(nodes);

  struct Flow {
    double work = 0.0, impulse = 0.0;
    Flow& operator+=(const Flow& other) {
      work += other.work;
      impulse += other.impulse;
      return *this;
    }
  };
  struct State {
    double energy = 0.0, momentum = 0.0, power = 0.0, wall_force = 0.0;
  };
  struct Piece {
    std::size_t interval;
    double from, to;
    Flow flow;
  };

  template <class Take>
  void film(const std::vector<double>& times, Take take) {
    Samples samples(times, column_.contacts());
    watch_(column_, samples);
    for (std::size_t s = 0; s < times.size(); ++s) take(samples.x(s), samples.u(s));
  }

  State at(std::span<const double> x, std::span<const double> u) const {
    const auto [beta, gamma] = column_.exponents;
    State state;
    double v = 0.0;
    for (std::size_t k = 0; k < column_.contacts(); ++k) {
      const double mass = column_.mass.empty() ? 1.0 : column_.mass[k];
      v -= u[k];
      state.energy += 0.5 * mass * v * v;
      state.momentum += mass * v;
      if (!(x[k] > 0.0)) continue;
      state.energy += column_.spring(k) * std::pow(x[k], 2.0 + beta) / (2.0 + beta);
      const double damping = column_.dashpot(k) * std::pow(x[k], gamma) * u[k];
      state.power += damping * u[k];
      if (k == 0) state.wall_force = column_.spring(0) * std::pow(x[0], 1.0 + beta) + damping;
    }
    return state;
  }

  void integrate(std::vector<Piece>& pieces) {
    std::vector<double> times;
    for (const Piece& piece : pieces)
      for (const double node : nodes) times.push_back(piece.from + (piece.to - piece.from) * node);
    std::size_t taken = 0;
    film(times, [&](auto x, auto u) {
      const State state = at(x, u);
      Piece& piece = pieces[taken / points];
      const double weight = (piece.to - piece.from) * weights[taken++ % points];
      piece.flow += {weight * state.power, weight * state.wall_force};
    });
  }

  /// Adds the pieces that are good to `flows` and hands back the halves of the others.
  std::vector<Piece> refined(const std::vector<Piece>& pieces, std::vector<Flow>& flows) {
    std::vector<Piece> halves, left;
    for (const Piece& piece : pieces) {
      const double middle = 0.5 * (piece.from + piece.to);
      halves.push_back({piece.interval, piece.from, middle, {}});
      halves.push_back({piece.interval, middle, piece.to, {}});
    }
    integrate(halves);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Piece &whole = pieces[i], &a = halves[2 * i], &b = halves[2 * i + 1];
      const bool same = std::fabs(whole.flow.work - a.flow.work - b.flow.work) <= agreed &&
                        std::fabs(whole.flow.impulse - a.flow.impulse - b.flow.impulse) <= agreed;
      if (same || !(a.to > a.from && b.to > b.from) || whole.to - whole.from < 1e-15 * whole.to) {
        flows[whole.interval] += a.flow;
        flows[whole.interval] += b.flow;
      } else {
        left.push_back(a);
        left.push_back(b);
      }
    }
    return left;
  }

  const Column<double>& column_;
  Watch watch_;
};

template <class Watch>
Books of(const Column<double>& column, double duration, std::size_t intervals, Watch watch) {
  return Accounts<Watch>(column, watch)(duration, intervals);
}

}  // namespace sigmasweep::books
