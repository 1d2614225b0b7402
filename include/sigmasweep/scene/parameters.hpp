#pragma once

#include <cstdint>
#include <string>

namespace sigmasweep {

/// How a collision is computed: soft spheres (contact time tc) or hard spheres (contact time zero).
enum class Method : std::uint8_t { md, ed };

/// The wall's restitution: `paper`, the same spring and the same dashpot as a pair of beads, so that
/// eps_wall = exp(-pi L/sqrt(2 pi^2 + L^2)), L = -ln eps; `matched`, the same (tc, eps) as a pair.
enum class Wall : std::uint8_t { paper, matched };

/// How soft spheres are moved: exactly between contact events, or by a scheme of fixed time step tc/steps_per_tc.
enum class Integrator : std::uint8_t { exact, gear5, verlet, rk4 };

/// Everything that defines one collision of a column of N beads with a fixed wall. SI units. A plain value of
/// fixed size: it is sent between ranks as it is. s0 and sigma = s0/(v0 tc) are kept together (see complete()).
struct Parameters {
  double v0 = 1.0;             ///< approach speed of the column, m/s
  double tc = 1e-5;            ///< contact time of a pair, s; Eq. (6)
  double s0 = 0.0;             ///< initial gap between neighbours and to the wall, m
  double sigma = 0.0;          ///< s0/(v0 tc), no unit
  double epsilon = 0.9;        ///< restitution of a pair, 0 < epsilon <= 1; Eq. (7)
  double d = 1e-3;             ///< bead diameter, m; drops out of every result of the linear law without gravity
  double steps_per_tc = 100.0; ///< fixed-step integrators: time step tc/steps_per_tc
  double tolerance = 1e-10;    ///< exact: wanted absolute error of eps_eff
  std::int64_t N = 10;         ///< number of beads
  Method method = Method::md;
  Wall wall = Wall::paper;
  Integrator integrator = Integrator::exact;
};

/// Which of the two gap parameters was given; the other one follows from it.
enum class Gap : std::uint8_t { s0, sigma };

/// `parameters` with the missing one of s0 and sigma filled in from the `given` one.
Parameters complete(Parameters parameters, Gap given);

/// Empty when `parameters` describe a collision; else one sentence naming the parameter, its value and what is allowed.
std::string why_invalid(const Parameters& parameters);

}  // namespace sigmasweep
