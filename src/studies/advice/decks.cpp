#include "studies/advice/decks.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace sigmasweep {
namespace {

/// pair_style gran/hooke: F = Kn x + m_red gamma_n x'. The pair's reduced mass is m/2, at the wall it is m.
std::string lammps(const Advice& a, double step) {
  return fmt::format(
      "units si\natom_style sphere\ncomm_modify vel yes\n"
      "pair_style gran/hooke {:.10g} 0 {:.10g} 0 0 0\npair_coeff * *\n"
      "fix wall all wall/gran hooke {:.10g} 0 {:.10g} 0 0 0 zplane 0 NULL\nfix move all nve/sphere\ntimestep {:.10g}\n",
      a.stiffness, 2.0 * a.dashpot / a.mass, a.wall_stiffness, a.wall_dashpot / a.mass, step);
}

/// model hooke/stiffness: as LAMMPS, with properties of pairs of types: 1 beads, 2 the wall.
std::string liggghts(const Advice& a, double step) {
  return fmt::format(
      "units si\natom_style granular\ncommunicate single vel yes\n"
      "fix kn all property/global kn peratomtypepair 2 {0:.10g} {1:.10g} {1:.10g} {1:.10g}\n"
      "fix kt all property/global kt peratomtypepair 2 0 0 0 0\n"
      "fix gamman all property/global gamman peratomtypepair 2 {2:.10g} {3:.10g} {3:.10g} {3:.10g}\n"
      "fix gammat all property/global gammat peratomtypepair 2 0 0 0 0\n"
      "fix friction all property/global coefficientFriction peratomtypepair 2 0 0 0 0\n"
      "pair_style gran model hooke/stiffness tangential off\npair_coeff * *\n"
      "fix wall all wall/gran model hooke/stiffness tangential off primitive type 2 zplane 0\n"
      "fix move all nve/sphere\ntimestep {4:.10g}\n",
      a.stiffness, a.wall_stiffness, 2.0 * a.dashpot / a.mass, a.wall_dashpot / a.mass, step);
}

/// ViscElMat: two materials in contact are springs and dashpots in series, so that each bead has twice those of a pair,
/// and a wall k with 1/k + 1/k_bead = 1/k_contact.
std::string yade(const Advice& a, double step) {
  const auto beside_bead = [](double contact, double pair) {
    return contact < 2.0 * pair ? fmt::format("{:.10g}", 2.0 * pair * contact / (2.0 * pair - contact)) : "1e300";
  };
  const double volume_mass = a.mass / (std::numbers::pi / 6.0 * a.tuple.d * a.tuple.d * a.tuple.d);
  return fmt::format(
      "bead = ViscElMat(density={:.10g}, kn={:.10g}, cn={:.10g}, ks=0.0, cs=0.0, frictionAngle=0.0)\n"
      "wall = ViscElMat(density={:.10g}, kn={}, cn={}, ks=0.0, cs=0.0, frictionAngle=0.0)\n"
      "# InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], "
      "[Ip2_ViscElMat_ViscElMat_ViscElPhys()],\n"
      "#                 [Law2_ScGeom_ViscElPhys_Basic()]), NewtonIntegrator(damping=0.0)\n"
      "O.dt = {:.10g}\n",
      volume_mass, 2.0 * a.stiffness, 2.0 * a.dashpot, volume_mass, beside_bead(a.wall_stiffness, a.stiffness),
      a.wall_dashpot > 0.0 ? beside_bead(a.wall_dashpot, a.dashpot) : "0.0", step);
}

/// F = stiffness x + dissipation x', of a species and of a mixed one.
std::string mercury(const Advice& a, double step) {
  return fmt::format(
      "auto beads = speciesHandler.copyAndAddObject(LinearViscoelasticSpecies());\n"
      "auto wall = speciesHandler.copyAndAddObject(LinearViscoelasticSpecies());\n"
      "beads->setStiffness({:.10g}); beads->setDissipation({:.10g});  // and beads->setDensity()\n"
      "auto mixed = speciesHandler.getMixedObject(beads, wall);\n"
      "mixed->setStiffness({:.10g}); mixed->setDissipation({:.10g});\nsetTimeStep({:.10g});\n",
      a.stiffness, a.dashpot, a.wall_stiffness, a.wall_dashpot, step);
}

}  // namespace

std::span<const Deck> decks() {
  static constexpr auto all = std::to_array<Deck>({
      {"LAMMPS", "", lammps},
      {"LIGGGHTS", "", liggghts},
      {"Yade", "leaves out the attractive last part of a contact: epsilon is a little larger there", yade},
      {"MercuryDPM", "not tried: it is no package of Debian", mercury},
  });
  return all;
}

}  // namespace sigmasweep
