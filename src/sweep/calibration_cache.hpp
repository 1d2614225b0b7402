#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sweep/grid.hpp"

namespace sigmasweep {

/// A cache of the results of derive_material() and derive_pair() for the tuples of a sweep, because both take long for
/// nonlinear laws. Results are the same to the bit. The cache is filled by the constructor and does not change later,
/// so that several threads can use it at once.
class CalibrationCache {
 public:
  /// Largest number of pairs in the cache; they take a second or two.
  static constexpr std::uint64_t max_pairs = 1 << 13;

  CalibrationCache(const Parameters& base, const std::vector<ParameterGrid::Group>& groups,
                   const Dependents& dependents);

  /// Does the same as derive_material() and derive_pair().
  void derive_contact(Parameters& parameters) const;
  /// Whether derive_contact() may take 0.1 ms or more, because the sweep has more than max_pairs different pairs.
  bool is_slow() const { return is_slow_; }

 private:
  struct Material {
    double d, K_over_m, D_n;
  };
  struct Pair {
    double tc, epsilon;
  };
  using MaterialKey = std::array<double, 3>;  ///< material, beta, gamma
  using PairKey = std::array<double, 5>;      ///< beta, gamma, K_over_m, D_n, v0

  static MaterialKey material_key(const Parameters& parameters);
  static PairKey pair_key(const Parameters& parameters);
  void insert(Parameters parameters, bool pairs_too);
  void derive_known_material(Parameters& parameters) const;

  std::map<MaterialKey, Material> materials_;
  std::map<PairKey, Pair> pairs_;
  bool is_slow_ = false;
};

/// The groups of axes on which tc and epsilon of a pair depend: law, stiffness, damping and v0. There are none if tc
/// and epsilon are given.
std::vector<ParameterGrid::Group> groups_of_pairs(const Parameters& base,
                                                  const std::vector<ParameterGrid::Group>& groups,
                                                  const Dependents& dependents);

/// Whether derive_pair() takes long, as it does for nonlinear laws with a given stiffness.
bool takes_long(const Parameters& parameters);

}  // namespace sigmasweep
