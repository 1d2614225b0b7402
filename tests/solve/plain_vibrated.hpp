#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

/// Hard spheres on a vibrating plate by a plain program in the room's frame that knows nothing of gaps, queues, rest or
/// clusters: parabolas, and the plate z0(t) = alpha sin t found by small steps. Units 1/omega and g/omega^2.
namespace sigmasweep::plain_vibrated {

using Long = long double;

struct Plain {
  Long alpha, e, e_wall;
  std::vector<Long> z, v;  ///< of the points that the beads would be if their diameters were 0, at `now`
  Long now = 0;
  std::uint64_t collisions = 0;

  Plain(double alpha_, double e_, double e_wall_, const std::vector<double>& gaps)
      : alpha(alpha_), e(e_), e_wall(e_wall_) {
    Long height = 0;
    for (const double gap : gaps) {
      z.push_back(height += gap);
      v.push_back(alpha);
    }
  }

  Long plate(Long t) const { return alpha * std::sin(t); }
  Long above_plate(Long elapsed) const { return z[0] + v[0] * elapsed - elapsed * elapsed / 2 - plate(now + elapsed); }

  /// Until bead 0, which is above the plate or leaves it, is there; at most `longest`.
  Long landing(Long longest) const {
    constexpr Long step = 1e-3L;
    Long before = 0;
    for (Long after = step;; after += step) {
      if (above_plate(after) < 0) {
        if (before == 0)  // a short hop: up to its top it is above the plate
          for (before = after; above_plate(before) < 0; before /= 2) {
          }
        for (int i = 0; i < 100; ++i) {
          const Long middle = (before + after) / 2;
          (above_plate(middle) < 0 ? after : before) = middle;
        }
        return before;
      }
      before = after;
      if (before > longest) return longest;
    }
  }

  void fly(Long elapsed) {
    for (std::size_t i = 0; i < z.size(); ++i) {
      z[i] += v[i] * elapsed - elapsed * elapsed / 2;
      v[i] -= elapsed;
    }
    now += elapsed;
  }

  /// To time `end` or just after the next collision, whichever comes first.
  void advance(Long end) {
    Long wait = end - now;
    std::size_t next = z.size();
    for (std::size_t i = 1; i < z.size(); ++i)
      if (v[i - 1] > v[i]) {
        const Long due = (z[i] - z[i - 1]) / (v[i - 1] - v[i]);
        if (due < wait) wait = due, next = i;
      }
    if (const Long due = landing(wait); due < wait) wait = due, next = 0;
    fly(wait);
    if (next == z.size()) return;
    ++collisions;
    if (next == 0) {
      const Long speed = alpha * std::cos(now);
      z[0] = plate(now);
      v[0] = speed + e_wall * (speed - v[0]);
    } else {
      const Long change = (1 + e) / 2 * (v[next - 1] - v[next]);
      z[next] = z[next - 1];
      v[next - 1] -= change;
      v[next] += change;
    }
  }
};

}  // namespace sigmasweep::plain_vibrated
