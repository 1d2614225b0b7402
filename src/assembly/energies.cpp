#include "assembly/energies.hpp"

#include <cmath>
#include <numeric>

#include "base/quad.hpp"
#include "numerics/double_double.hpp"

namespace sigmasweep {

namespace {

template <class Real>
Real mass_of(std::span<const Real> mass, std::size_t bead) {
  return mass.empty() ? Real(1) : mass[bead];
}

template <class Real>
Real total(std::span<const Real> mass, std::size_t beads) {
  if (mass.empty()) return Real(static_cast<double>(beads));
  return std::accumulate(mass.begin(), mass.end(), Real(0));
}

}  // namespace

template <class Real>
Energies<Real> energies(std::span<const Real> velocity, Real speed, std::span<const Real> mass) {
  using std::sqrt;
  const Real all = total(mass, velocity.size());
  Real momentum = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) momentum += mass_of(mass, i) * (velocity[i] / speed);
  const Real v_cm = momentum / all;
  // E_f/E_0 = E_r/E_0 + v_cm^2 without cancellation.
  Real relative = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const Real v = velocity[i] / speed - v_cm;
    relative += mass_of(mass, i) * v * v;
  }
  const Real Er_E0 = relative / all;
  const Real Ef_E0 = Er_E0 + v_cm * v_cm;
  Energies<Real> e;
  e.eps_eff = sqrt(Ef_E0);
  e.Er_E0 = Er_E0;
  e.Er_Ef = Ef_E0 > 0 ? Real(Er_E0 / Ef_E0) : Real(0);
  e.v_cm = v_cm;
  return e;
}

template <class Real>
Real distance(std::span<const Real> velocity, std::span<const Real> other, std::span<const Real> mass) {
  using std::sqrt;
  Real squares = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    squares += mass_of(mass, i) * (velocity[i] - other[i]) * (velocity[i] - other[i]);
  return sqrt(squares / total(mass, velocity.size()));
}

template <class Real>
Projection<Real> project_on_separated(std::span<const Real> velocity, std::span<const Real> mass) {
  struct Block {
    Real momentum, mass;
    std::size_t beads;
    Real mean() const { return momentum / mass; }
  };
  std::vector<Block> blocks;  // projection onto w_1 <= ... <= w_N, then cut at 0
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const Real m = mass_of(mass, i);
    blocks.push_back({m * velocity[i], m, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().momentum += last.momentum;
      blocks.back().mass += last.mass;
      blocks.back().beads += last.beads;
    }
  }
  Projection<Real> norms;
  std::size_t bead = 0;
  for (const Block& block : blocks) {
    const Real w = block.mean() > 0 ? block.mean() : Real(0);
    norms.kept += block.mass * w * w;
    for (std::size_t i = 0; i < block.beads; ++i, ++bead)
      norms.lost += mass_of(mass, bead) * (velocity[bead] - w) * (velocity[bead] - w);
  }
  return norms;
}

template <class Real>
Real residual_dissipation(std::span<const Real> velocity, Real speed, std::span<const Real> mass) {
  using std::sqrt;
  const auto [lost, kept] = project_on_separated(velocity, mass);
  if (!(lost > 0)) return Real(0);
  // |v| - |Pv| without cancellation; |v|^2 = |Pv|^2 + |v - Pv|^2
  return lost / ((sqrt(lost + kept) + sqrt(kept)) * sqrt(total(mass, velocity.size())) * speed);
}

#define SIGMASWEEP_INSTANTIATE(Real)                                                                     \
  template Energies<Real> energies(std::span<const Real> velocity, Real speed, std::span<const Real>);   \
  template Real distance(std::span<const Real>, std::span<const Real>, std::span<const Real>);           \
  template Projection<Real> project_on_separated(std::span<const Real> velocity, std::span<const Real>); \
  template Real residual_dissipation(std::span<const Real> velocity, Real speed, std::span<const Real>);
SIGMASWEEP_INSTANTIATE(double)
SIGMASWEEP_INSTANTIATE(long double)
SIGMASWEEP_INSTANTIATE(DoubleDouble)
SIGMASWEEP_INSTANTIATE(Quad)
#undef SIGMASWEEP_INSTANTIATE

}  // namespace sigmasweep
