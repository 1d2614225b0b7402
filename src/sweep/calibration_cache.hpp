#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sigmasweep/assembly/complete.hpp"
#include "sweep/grid.hpp"

namespace sigmasweep {

/// The contacts of a sweep: what derive_material() and derive_pair() say, to the bit, without the time that they take
/// with laws that are not linear. Nothing changes after construction: safe from several threads at once.
class CalibrationCache {
 public:
  /// At most this many pairs are worked out beforehand: a second or two.
  static constexpr std::uint64_t max_remembered = 1 << 13;

  CalibrationCache(const Parameters& base, const std::vector<ParameterGrid::Group>& groups);

  /// derive_material() and derive_pair().
  void give(Parameters& parameters) const;
  /// Whether give() takes 0.1 ms and more, because there are too many different pairs to remember.
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
  void learn(Parameters parameters, bool pairs_too);
  void derive_known_material(Parameters& parameters) const;

  std::map<MaterialKey, Material> materials_;
  std::map<PairKey, Pair> pairs_;
  bool is_slow_ = false;
};

/// The groups that decide what the pairs of a sweep are like: those with an axis of the law, the stiffness, the damping
/// or v0. None where tc and epsilon are given.
std::vector<ParameterGrid::Group> deciding_contacts(const Parameters& base,
                                                    const std::vector<ParameterGrid::Group>& groups);

/// Whether derive_pair() takes long: for laws that are not linear with a stiffness of their own.
bool takes_long(const Parameters& parameters);

}  // namespace sigmasweep
