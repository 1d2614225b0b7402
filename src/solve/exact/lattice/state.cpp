#include "solve/exact/lattice/state.hpp"

#include <algorithm>

namespace sigmasweep {

template <class Real, class Ground>
LatticeState<Real, Ground>::LatticeState(const Lattice<Real>& lattice_, const Ground& ground_)
    : lattice(lattice_),
      ground(ground_),
      neighbours(lattice_),
      beads(lattice_.count()),
      touching(lattice_.count()),
      mark(lattice_.count()) {
  for (std::size_t i = 0; i < beads.size(); ++i) {
    if (!lattice.shift.empty()) beads[i].q = lattice.shift[i];
    if constexpr (!Ground::moves) beads[i].v = {Real(0), -lattice.beads.speed};
  }
}

template <class Real, class Ground>
BeadState<Real> LatticeState<Real, Ground>::at(std::size_t i, const Real& t) const {
  const Bead& bead = beads[i];
  if (bead.cluster >= 0) return clusters[std::size_t(bead.cluster)].cluster->at(bead.place, t);
  const Real elapsed = t - bead.since;
  BeadState<Real> state{bead.q + elapsed * bead.v, bead.v, {}};
  if constexpr (Ground::moves) {
    const auto fall = ground.flight({-bead.q.z, -bead.v.z}, bead.since, elapsed);  // x grows downwards
    state.q.z = -fall.x;
    state.v.z = -fall.u;
    state.a.z = -ground.load(double(t));
  }
  return state;
}

template <class Real, class Ground>
Real LatticeState<Real, Ground>::until(std::size_t i) const {
  const Bead& bead = beads[i];
  return bead.cluster < 0 ? never : clusters[std::size_t(bead.cluster)].cluster->end();
}

template <class Real, class Ground>
Motion<Real> LatticeState<Real, Ground>::gap(std::size_t i, const Neighbour<Real>& other, const Real& t) const {
  BeadState<Real> s = at(i, t);
  if (!other.is_wall()) {
    const BeadState<Real> o = at(other.bead, t);
    s = {s.q - o.q, s.v - o.v, s.a - o.a};
  }
  return other.bond.gap_of(s);
}

template <class Real, class Ground>
bool LatticeState<Real, Ground>::touches(std::size_t i, const Neighbour<Real>& other) const {
  return std::ranges::any_of(touching[i], [&](const Neighbour<Real>& n) { return n.is(other.bead, other.image); });
}

template struct LatticeState<double, FixedWall>;
template struct LatticeState<long double, FixedWall>;
template struct LatticeState<double, Plate>;

}  // namespace sigmasweep
