#pragma once

#include "sigmasweep/model/parameters.hpp"

/// Parameters that follow from the given ones.
namespace sigmasweep {

/// Which of the two gap parameters was given; the other one follows from it.
enum class GapParameter : std::uint8_t { s0, sigma };

/// `parameters` with what follows from what is given: the material's d, K_over_m and D_n; with a K_over_m > 0 tc and
/// epsilon at v0; then the missing one of s0 and sigma. A pair too damped to come apart again (linear law: D_n >=
/// sqrt(K_over_m)) has epsilon = 0, and as tc the contact time without damping, pi/sqrt(K_over_m), (A2) with beta = 0:
/// a unit of time, not a duration. Only soft spheres (md) can be that damped.
Parameters complete(Parameters parameters, GapParameter given);

/// The steps of complete(), for those who remember what the first two gave: they take time, milliseconds for a material
/// and 0.1 ms for a pair, with laws that are not linear.
void derive_material(Parameters& parameters);
void derive_pair(Parameters& parameters);
void derive_gap(Parameters& parameters, GapParameter given);
/// N of a lattice.
void derive_beads(Parameters& parameters);
/// A step of complete(), for what vibrates: alpha = A0 (2 pi f)^2/g and A0, the missing one from the other. Where
/// both are there and differ A0 counts. What is complete already stays as it is, to the bit.
void derive_plate_motion(Parameters& parameters);

}  // namespace sigmasweep
