#include "bench/peers/tuples.hpp"

#include <cmath>

#include "assembly/energies.hpp"
#include "base/quad.hpp"
#include "base/random.hpp"
#include "solve/exact/linear/collision.hpp"
#include "support/parameters.hpp"

namespace sigmasweep::peers {
namespace {

constexpr double sigmas[] = {0.0, 0.01, 0.1, 0.3, 1.0, 2.0, 10.0};
constexpr double change_of_sigma = 0.05;

double chance(const char* purpose, std::size_t k) { return unit_interval(random_bits(stream_key(1, purpose), k)); }

double true_value(const Parameters& p) {
  RunLimits to_the_end;
  to_the_end.settle = 1e-20;
  const auto outcome = exact_collision<Quad>(reduced_column<Quad>(p), to_the_end);
  return static_cast<double>(energies<Quad>(outcome.velocity, Quad(1)).eps_eff);
}

Tuple variation(double sigma, std::size_t k, std::size_t number) {
  const double change = k == 0 ? 0.0 : change_of_sigma * (2.0 * chance("sigma", number) - 1.0);
  Tuple tuple;
  tuple.parameters = soft_column({.v0 = 0.05 * std::pow(40.0, chance("v0", number)),
                                  .tc = 1e-6 * std::pow(100.0, chance("tc", number)),
                                  .sigma = sigma * (1.0 + change),
                                  .epsilon = epsilon,
                                  .N = beads});
  tuple.phase = chance("phase", number);
  tuple.eps_eff = true_value(tuple.parameters);
  return tuple;
}

}  // namespace

std::vector<Group> reference_set(std::size_t variations) {
  std::vector<Group> groups;
  std::size_t number = 0;
  for (const double sigma : sigmas) {
    Group& group = groups.emplace_back(Group{.sigma = sigma, .tuples = {}});
    for (std::size_t k = 0; k < variations; ++k) group.tuples.push_back(variation(sigma, k, number++));
  }
  return groups;
}

}  // namespace sigmasweep::peers
