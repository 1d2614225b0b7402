#include "solve/hard_spheres/cluster.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace sigmasweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double mass_of(std::span<const double> mass, std::size_t bead) { return mass.empty() ? 1.0 : mass[bead]; }

struct Block {
  std::size_t first, beads;
  double momentum, mass, velocity;
  std::size_t end() const { return first + beads; }
};

/// Velocities relative to the lowest bead. The wall's block keeps velocity 0: nothing moves the wall.
std::vector<Block> pooled(std::span<const double> velocity, bool on_wall, std::span<const double> mass) {
  std::vector<Block> blocks;
  for (std::size_t bead = 0; bead < velocity.size(); ++bead) {
    const double m = mass_of(mass, bead);
    blocks.push_back({bead, 1, m * velocity[bead], m, velocity[bead]});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].velocity >= blocks.back().velocity) {
      const Block above = blocks.back();
      blocks.pop_back();
      Block& block = blocks.back();
      block.beads += above.beads;
      block.momentum += above.momentum;
      block.mass += above.mass;
      block.velocity = on_wall && block.first == 0 ? 0.0 : block.momentum / block.mass;
    }
  }
  return blocks;
}

}  // namespace

Cluster cluster_around(std::size_t k, std::span<const double> u, bool on_wall, std::span<const double> mass) {
  std::vector<double> velocity{0.0};
  for (const double closing : u) velocity.push_back(velocity.back() - closing);
  const std::vector<Block> blocks = pooled(velocity, on_wall, mass);

  std::size_t b = 0;
  while (blocks[b].end() <= k + 1) ++b;  // contact k is below bead k + 1
  const Block& block = blocks[b];
  Cluster cluster{.first = block.first,
                  .beads = block.beads,
                  .wall = on_wall && block.first == 0,
                  .bottom_change = block.velocity - velocity[block.first],
                  .top_change = block.velocity - velocity[block.end() - 1],
                  .fastest = u[k],
                  .least_impulse = infinity,
                  .parting = infinity};
  double impulse = 0.0;
  for (std::size_t bead = block.end() - 1; bead > block.first; --bead) {
    impulse += mass_of(mass, bead) * (block.velocity - velocity[bead]);
    cluster.least_impulse = std::min(cluster.least_impulse, impulse);
  }
  if (b > 0) cluster.parting = block.velocity - blocks[b - 1].velocity;
  if (b + 1 < blocks.size()) cluster.parting = std::min(cluster.parting, blocks[b + 1].velocity - block.velocity);
  return cluster;
}

bool will_collapse(const Cluster& cluster, double eps) {
  const double n = static_cast<double>(cluster.beads) * (cluster.wall ? 1.0 : 0.5);
  if (n < 2.0) return false;
  const double tangent = std::tan(0.25 * std::numbers::pi * (1.0 - 1.0 / n));
  const double threshold = 1.0 - tangent * tangent;
  return 1.0 - eps >= 1.25 * threshold && cluster.fastest <= 0.25 * cluster.least_impulse &&
         cluster.fastest <= cluster.parting;
}

}  // namespace sigmasweep
