#include "sigmasweep/solve/column.hpp"

#include <cmath>

#include "sigmasweep/scene/real.hpp"

namespace sigmasweep {

template <class Real>
Energies<Real> energies(std::span<const Real> velocity, Real speed) {
  using std::sqrt;
  const Real n = static_cast<double>(velocity.size());
  Real momentum = 0;
  for (const Real& v : velocity) momentum += v / speed;
  const Real v_cm = momentum / n;
  // E_f/E_0 = E_r/E_0 + v_cm^2 without cancellation.
  Real relative = 0;
  for (const Real& v : velocity) relative += (v / speed - v_cm) * (v / speed - v_cm);
  const Real Er_E0 = relative / n;
  const Real Ef_E0 = Er_E0 + v_cm * v_cm;
  Energies<Real> e;
  e.eps_eff = sqrt(Ef_E0);
  e.Er_E0 = Er_E0;
  e.Er_Ef = Ef_E0 > 0 ? Real(Er_E0 / Ef_E0) : Real(0);
  e.v_cm = v_cm;
  return e;
}

template <class Real>
Real distance_to_separated(std::span<const Real> velocity) {
  struct Block {
    Real sum;
    double beads;
    Real mean() const { return sum / beads; }
  };
  std::vector<Block> blocks;  // projection onto w_1 <= ... <= w_N, then cut at 0
  for (const Real& v : velocity) {
    blocks.push_back({v, 1.0});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().beads += last.beads;
    }
  }
  Real distance = 0;
  std::size_t bead = 0;
  for (const Block& block : blocks) {
    const Real w = block.mean() > 0 ? block.mean() : Real(0);
    for (double i = 0; i < block.beads; ++i, ++bead) distance += (velocity[bead] - w) * (velocity[bead] - w);
  }
  return distance;
}

template <class Real>
Real residual_dissipation(std::span<const Real> velocity, Real speed) {
  using std::sqrt;
  const Real lost = distance_to_separated(velocity);
  if (!(lost > 0)) return Real(0);
  Real total = 0;
  for (const Real& v : velocity) total += v * v;
  // |v| - |Pv| without cancellation
  const Real kept = total > lost ? Real(total - lost) : Real(0);
  return lost / ((sqrt(total) + sqrt(kept)) * sqrt(Real(static_cast<double>(velocity.size()))) * speed);
}

#define SIGMASWEEP_INSTANTIATE(Real)                                                 \
  template Energies<Real> energies(std::span<const Real> velocity, Real speed);      \
  template Real distance_to_separated(std::span<const Real> velocity);               \
  template Real residual_dissipation(std::span<const Real> velocity, Real speed);
SIGMASWEEP_INSTANTIATE(double)
SIGMASWEEP_INSTANTIATE(long double)
SIGMASWEEP_INSTANTIATE(Quad)
#undef SIGMASWEEP_INSTANTIATE

}  // namespace sigmasweep
