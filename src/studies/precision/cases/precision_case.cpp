#include "studies/precision/cases/precision_case.hpp"

#include "base/random.hpp"

namespace sigmasweep {

double chance(const PrecisionSpec& spec, const char* purpose, std::uint64_t k) {
  return unit_interval(random_bits(stream_key(spec.seed, purpose), k));
}

std::vector<Parameters> with_other_sigmas(const Parameters& scene, const PrecisionSpec& spec) {
  std::vector<Parameters> tuples(scene.sigma > 0.0 ? spec.tuples : 1, scene);
  for (std::size_t k = 0; k < tuples.size(); ++k) {
    tuples[k].sigma *= 1.0 + scene_change * (2.0 * chance(spec, "sigma", k) - 1.0);
    tuples[k].s0 = tuples[k].sigma * tuples[k].v0 * tuples[k].tc;
  }
  return tuples;
}

}  // namespace sigmasweep
