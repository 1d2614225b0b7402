#pragma once

#include "sigmasweep/model/parameters.hpp"

/// Parameters that are derived from given ones.
namespace sigmasweep {

/// The gap parameter that is given; the other one follows from it.
enum class GapParameter : std::uint8_t { s0, sigma };

/// `parameters` with all derived ones: a material's d, K_over_m and D_n; tc and epsilon at v0 if K_over_m > 0; the
/// other one of s0 and sigma. A pair that is too damped to separate (linear law: D_n >= sqrt(K_over_m)) has epsilon =
/// 0. Its tc is a unit of time only, the contact time without damping, pi/sqrt(K_over_m), (A2) with beta = 0. Only soft
/// spheres (md) can have such a damping.
Parameters complete(Parameters parameters, GapParameter given);

/// The steps of complete(), for caches of the results of the first two. For nonlinear laws a material takes
/// milliseconds, a pair 0.1 ms.
void derive_material(Parameters& parameters);
void derive_pair(Parameters& parameters);
void derive_gap(Parameters& parameters, GapParameter given);
/// Derives N of a lattice.
void derive_beads(Parameters& parameters);
/// Derives the missing one of alpha = A0 (2 pi f)^2/g and A0 for a plate. If both are given and differ, alpha is
/// derived from A0. Complete parameters do not change by a bit.
void derive_plate_motion(Parameters& parameters);

}  // namespace sigmasweep
