#pragma once

#include <cstdint>

#include "sigmasweep/model/names.hpp"

namespace sigmasweep {

/// How a collision is computed: soft spheres (contact time tc) or hard spheres (contact time zero).
enum class Method : std::uint8_t { md, ed };
constexpr auto enumerator_names(Method) { return names_up_to<Method::ed>("md", "ed"); }

/// How the beads are put together and what they meet: a column that flies into a fixed wall; a column that rests on a
/// plate, under gravity, when the plate begins to vibrate (Sec. V); or, in two dimensions, a triangular lattice instead
/// of the column (Secs. II A, IV C).
enum class Geometry : std::uint8_t { column, vibrated_column, lattice, vibrated_lattice };

/// The sides of a lattice: `periodic`, the container repeats itself to the left and right; `fixed`, walls like the
/// bottom.
enum class SideWalls : std::uint8_t { periodic, fixed };
constexpr auto enumerator_names(SideWalls) { return names_up_to<SideWalls::fixed>("periodic", "fixed"); }

/// The wall's or plate's contact: `paper`, the same spring and the same dashpot as a pair of beads, so that
/// eps_wall = exp(-pi L/sqrt(2 pi^2 + L^2)), L = -ln eps; `matched`, the same (tc, eps) as a pair.
enum class Wall : std::uint8_t { paper, matched };
constexpr auto enumerator_names(Wall) { return names_up_to<Wall::matched>("paper", "matched"); }

/// How the motion of soft spheres is integrated: exactly between contact events, or by a scheme of fixed time step
/// tc/steps_per_tc.
enum class Integrator : std::uint8_t { exact, gear5, verlet, rk4, leapfrog };
constexpr auto enumerator_names(Integrator) {
  return names_up_to<Integrator::leapfrog>("exact", "gear5", "verlet", "rk4", "leapfrog");
}

/// The contact force F = K x^(1+beta) + D x^gamma x', x > 0 the overlap; Eqs. (2), (3), (8) and Sec. IV B. The
/// exponents are in the table of laws (law.hpp).
enum class Law : std::uint8_t { hooke, hertz, hertz_kuwabara_kono, taguchi, power, cone };

/// Beads of the paper's Sec. III; none: stiffness and damping are given by other parameters.
enum class Material : std::uint8_t { none, steel, aluminium };
constexpr auto enumerator_names(Material) { return names_up_to<Material::aluminium>("none", "steel", "aluminium"); }

/// When a collision of hard spheres dissipates energy: `lrv`, always; `tc`, unless one of the two beads collided less
/// than tc ago (S. Luding & S. McNamara, Granular Matter 1, 113 (1998)).
enum class EdRule : std::uint8_t { lrv, tc };
constexpr auto enumerator_names(EdRule) { return names_up_to<EdRule::tc>("lrv", "tc"); }

/// A truth value, which users write as true or false.
enum class Flag : std::uint8_t { no, yes };
constexpr auto enumerator_names(Flag) { return names_up_to<Flag::yes>("false", "true"); }

/// Everything that defines one tuple: one collision of a column or lattice with a fixed wall, or one run on a plate
/// that vibrates. SI units. A plain value of fixed size, which is sent between ranks as it is. Stiffness and damping
/// are given by (tc, epsilon), by (K_over_m, D_n) or by the material; s0 and sigma = s0/(v0 tc) are kept together, as
/// are alpha and A0. complete() derives from the given parameters the others. Each member has a row in the table of
/// parameters (src/model/fields/parameters.hpp).
struct Parameters {
  double v0 = 1.0;        ///< approach speed of the column, m/s
  double tc = 1e-5;       ///< contact time of a pair at v0, s: Eq. (6); of laws that are not linear, Eq. (A2)
  double s0 = 0.0;        ///< initial gap between neighbours and to the wall, m
  double sigma = 0.0;     ///< s0/(v0 tc), no unit
  double epsilon = 0.9;   ///< restitution of a pair at v0, Eq. (7); 0: the pair never comes apart
  double K_over_m = 0.0;  ///< spring over reduced mass, 1/(s^2 m^beta); 0: from tc
  double D_n = 0.0;       ///< dashpot over m_ij, twice the reduced mass, 1/(s m^gamma); only with K_over_m
  double beta = 0.0;      ///< power law: exponent of the spring
  double gamma = 0.0;     ///< power law: exponent of the dashpot
  double d = 1e-3;        ///< bead diameter, m; without gravity no result of a column of the linear law depends on it
  double D_t = 0.0;       ///< lattice: tangential dashpot over m_ij, Eq. (4), 1/s
  double width = 0.0;     ///< diameters are uniform in d +- width/2, m; masses go with their cubes
  double steps_per_tc = 100.0;  ///< fixed-step integrators: time step tc/steps_per_tc; 0: chosen by the tolerance
  double tolerance = 1e-10;     ///< wanted absolute error of eps_eff, of exact or of a time step chosen for it
  double gravity = 9.81;        ///< acceleration of gravity where a plate vibrates, m/s^2
  double frequency = 20.0;      ///< f of the plate z0(t) = A0 sin(2 pi f t), Eq. (1), Hz
  double alpha = 0.0;           ///< A0 (2 pi f)^2/g, the plate's largest acceleration over gravity
  double A0 = 0.0;              ///< the plate's amplitude, m
  std::int64_t periods = 120;   ///< periods of the plate that are computed
  std::int64_t transient = 20;  ///< initial periods that are excluded from the averages
  std::int64_t N = 10;          ///< number of beads; of a lattice, rows times columns
  std::int64_t rows = 10;       ///< lattice: its height h
  std::int64_t columns = 13;    ///< lattice: beads in a row
  std::int64_t seed = 0;        ///< seed of random diameters and separations
  Geometry geometry = Geometry::column;
  Method method = Method::md;
  Wall wall = Wall::paper;
  Integrator integrator = Integrator::exact;
  Law law = Law::hooke;
  Material material = Material::none;
  EdRule ed_rule = EdRule::lrv;
  SideWalls side_walls = SideWalls::periodic;  ///< lattice
  Flag random_separation = Flag::no;           ///< each bead shifted by up to +- s0/2 at the start, Sec. IV
};

}  // namespace sigmasweep
