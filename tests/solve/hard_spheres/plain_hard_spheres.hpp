#pragma once

#include <cstdint>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "assembly/column.hpp"
#include "base/quad.hpp"
#include "sigmasweep/model/parameters.hpp"

/// Hard spheres by a plain program of fifty digits that knows nothing of queues, clusters or settling.
namespace sigmasweep::plain_hard_spheres {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// Shorter distances and slower approaches are none.
inline const Wide none("1e-35");

struct Plain {
  std::vector<Wide> x, v, m, last;  ///< of the wall (bead 0) and the beads
  Wide eps, eps_wall, tc, now = 0;
  bool tc_model;
  std::uint64_t collisions = 0;

  Plain(const Column<Quad>& c, EdRule rule)
      : x(1, 0),
        v(1, 0),
        m(1, 0),
        last(1, -1),
        eps(c.eps),
        eps_wall(c.eps_wall),
        tc(c.tc),
        tc_model(rule == EdRule::tc) {
    for (std::size_t k = 0; k < c.contacts(); ++k) {
      x.push_back(x.back() + Wide(c.initial_gap(k)));
      v.push_back(-Wide(c.speed));
      m.push_back(c.mass.empty() ? Wide(1) : Wide(c.mass[k]));
      last.push_back(-1);  // no collision yet
    }
  }

  Wide closing(std::size_t k) const { return v[k - 1] - v[k]; }
  bool clock_runs(std::size_t bead) const { return bead > 0 && last[bead] >= 0 && now - last[bead] < tc - none; }

  /// The fastest of the pairs that touch and approach; 0 if there is none.
  std::size_t impact() const {
    std::size_t fastest = 0;
    for (std::size_t k = 1; k < x.size(); ++k)
      if (x[k] - x[k - 1] < none && closing(k) > none && (fastest == 0 || closing(k) > closing(fastest) + none))
        fastest = k;
    return fastest;
  }

  void collide(std::size_t k) {
    Wide e = k == 1 ? eps_wall : eps;
    if (tc_model && (clock_runs(k - 1) || clock_runs(k))) e = 1;
    const Wide u = closing(k);
    if (k == 1) {
      v[1] += (1 + e) * u;
    } else {
      const Wide impulse = (1 + e) * u * m[k - 1] * m[k] / (m[k - 1] + m[k]);
      v[k - 1] -= impulse / m[k - 1];
      v[k] += impulse / m[k];
    }
    last[k - 1] = last[k] = now;
    ++collisions;
  }

  /// False when no pair approaches any more, or after `limit` collisions.
  bool run(std::uint64_t limit) {
    while (collisions < limit) {
      if (const std::size_t k = impact(); k > 0) {
        collide(k);
        continue;
      }
      Wide soonest = -1;
      for (std::size_t k = 1; k < x.size(); ++k)
        if (closing(k) > none) {
          const Wide due = (x[k] - x[k - 1]) / closing(k);
          if (soonest < 0 || due < soonest) soonest = due;
        }
      if (soonest < 0) return true;
      now += soonest;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] += v[k] * soonest;
    }
    return false;
  }

  Wide eps_eff(const Wide& speed) const {
    Wide energy = 0, mass = 0;
    for (std::size_t k = 1; k < x.size(); ++k) {
      energy += m[k] * v[k] * v[k];
      mass += m[k];
    }
    return sqrt(energy / mass) / speed;
  }
};

}  // namespace sigmasweep::plain_hard_spheres
