#include "sweep/calibration_cache.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "sigmasweep/assembly/complete.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

constexpr auto of_material = std::to_array<std::string_view>({"law", "beta", "gamma", "material"});
constexpr auto of_pair = std::to_array<std::string_view>({"law", "beta", "gamma", "material", "K_over_m", "D_n", "v0"});

/// The groups with axes on which parameters depend.
std::vector<ParameterGrid::Group> with_axis(const std::vector<ParameterGrid::Group>& groups,
                                            const Dependents& dependents,
                                            std::span<const std::string_view> parameters) {
  return groups_with(groups, dependents.with_causes(parameters));
}

bool has_own_stiffness(const Parameters& base, const std::vector<ParameterGrid::Group>& groups) {
  static constexpr auto given = std::to_array<std::string_view>({"K_over_m", "material"});
  return base.K_over_m > 0.0 || base.material != Material::none || !groups_with(groups, given).empty();
}

bool is_small(const std::vector<ParameterGrid::Group>& groups) {
  return count_of(groups) <= static_cast<double>(CalibrationCache::max_pairs);
}

}  // namespace

bool takes_long(const Parameters& p) {
  return (p.K_over_m > 0.0 || p.material != Material::none) && !exponents(p).linear();
}

std::vector<ParameterGrid::Group> groups_of_pairs(const Parameters& base,
                                                  const std::vector<ParameterGrid::Group>& groups,
                                                  const Dependents& dependents) {
  return has_own_stiffness(base, groups) ? with_axis(groups, dependents, of_pair) : std::vector<ParameterGrid::Group>{};
}

CalibrationCache::CalibrationCache(const Parameters& base, const std::vector<ParameterGrid::Group>& groups,
                                   const Dependents& dependents) {
  if (!has_own_stiffness(base, groups)) return;
  const auto tuple = [&](const std::vector<ParameterGrid::Group>& deciding, std::uint64_t i) {
    Parameters p = values_at(base, deciding, i);
    dependents.set(p);
    return p;
  };
  for (const bool pairs_too : {false, true}) {
    const auto deciding =
        with_axis(groups, dependents, pairs_too ? std::span<const std::string_view>(of_pair) : of_material);
    if (!is_small(deciding)) continue;
    for (std::uint64_t i = 0; i < size_of(deciding); ++i) insert(tuple(deciding, i), pairs_too);
  }
  const auto deciding = with_axis(groups, dependents, of_pair);
  if (is_small(deciding)) return;
  const auto materials = with_axis(groups, dependents, of_material);
  for (std::uint64_t i = 0; i < std::min(size_of(materials), max_pairs); ++i)
    is_slow_ = is_slow_ || takes_long(tuple(materials, i));
}

CalibrationCache::MaterialKey CalibrationCache::material_key(const Parameters& p) {
  const auto [beta, gamma] = exponents(p);
  return {static_cast<double>(p.material), beta, gamma};
}

CalibrationCache::PairKey CalibrationCache::pair_key(const Parameters& p) {
  const auto [beta, gamma] = exponents(p);
  return {beta, gamma, p.K_over_m, p.D_n, p.v0};
}

void CalibrationCache::insert(Parameters p, bool pairs_too) {
  if (!takes_long(p)) return;
  if (p.material != sigmasweep::Material::none) {
    const auto [known, is_new] = materials_.try_emplace(material_key(p));
    if (is_new) {
      derive_material(p);
      known->second = {p.d, p.K_over_m, p.D_n};
    }
    derive_known_material(p);
  }
  if (!pairs_too || std::isnan(p.D_n)) return;
  const auto [known, is_new] = pairs_.try_emplace(pair_key(p));
  if (!is_new) return;
  derive_pair(p);
  known->second = {p.tc, p.epsilon};
}

void CalibrationCache::derive_known_material(Parameters& p) const {
  if (p.material == sigmasweep::Material::none) return;
  const auto known = materials_.find(material_key(p));
  if (known == materials_.end()) return derive_material(p);
  p.d = known->second.d;
  p.K_over_m = known->second.K_over_m;
  p.D_n = known->second.D_n;
}

void CalibrationCache::derive_contact(Parameters& p) const {
  derive_known_material(p);
  if (pairs_.empty() || !takes_long(p) || std::isnan(p.D_n)) return derive_pair(p);
  const auto known = pairs_.find(pair_key(p));
  if (known == pairs_.end()) return derive_pair(p);
  p.tc = known->second.tc;
  p.epsilon = known->second.epsilon;
}

}  // namespace sigmasweep
