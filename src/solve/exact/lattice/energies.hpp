#pragma once

#include "solve/exact/lattice/state.hpp"

namespace sigmasweep {

/// Energies of a lattice at a time at which all motions are known, and the losses that they allow.
template <class Real, class Ground>
class LatticeEnergies {
 public:
  using State = LatticeState<Real, Ground>;
  explicit LatticeEnergies(const State& state) : state_(state) {}

  Real kinetic(const Real& t) const;
  Real energy_at_start() const;
  /// Energy that pairs which approach, with nothing in touch, can lose: the sum of 1/2 m_red u^2.
  Real approach(const Real& t) const;
  /// Energy that touching pairs can still lose. Overdamped pairs never quite open.
  Real held(const Real& t) const;
  /// Change of eps_eff = sqrt(E/E_0) by a loss of energy.
  Real later_change(const Real& loss, const Real& t) const;
  /// Energy on the plate, see energy_on_plate(). Potential energy counts from the initial sites.
  double energy(const Real& t) const requires(Ground::moves);

 private:
  const State& state_;
};

}  // namespace sigmasweep
