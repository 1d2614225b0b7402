#include "solve/hard_spheres/many.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "solve/hard_spheres/collision.hpp"

namespace sigmasweep {
namespace {

/// All that a collision depends on in units of the gap and the speed: N, epsilon, the wall, and whether there are gaps;
/// and the tolerance, which says when it is over.
using Scaled = std::tuple<std::int64_t, double, Wall, bool, double>;

constexpr std::int64_t most_beads = 100;  ///< longer columns have too many collisions

bool is_scaled(const Parameters& p) {
  return p.N <= most_beads && p.ed_rule == EdRule::lrv && p.width == 0.0 && p.random_separation == Flag::no;
}

/// In SI units, by the same operations as for the tuple alone: by the gap over v0 tc, and then by tc.
SimulationResult in_si(const HardSphereResult& shared, const Parameters& p) {
  SimulationResult c = shared.result;
  c.t_k = (shared.t_k * (p.sigma > 0.0 ? p.sigma : 1.0)) * p.tc;
  return c;
}

}  // namespace

void simulate_hard_spheres_many(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  std::map<Scaled, std::optional<HardSphereResult>> known;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameters& p = parameters[i];
    if (!is_scaled(p)) continue;
    const Scaled scaled{p.N, p.epsilon, p.wall, p.sigma > 0.0, p.tolerance};
    auto found = known.find(scaled);
    if (found == known.end()) found = known.emplace(scaled, short_hard_sphere_run(p)).first;
    if (!found->second) continue;
    const SimulationResult c = in_si(*found->second, p);
    if (std::isfinite(c.t_k)) results[i] = c;
  }
}

}  // namespace sigmasweep
