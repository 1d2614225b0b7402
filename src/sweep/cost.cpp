#include "sigmasweep/sweep/cost.hpp"

#include <algorithm>
#include <array>

#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"

namespace sigmasweep {
namespace {

/// What the parts of a solution cost, s. Fitted to single tuples (N = 1 to 200, epsilon = 0.6 to 1, all sigma) on a
/// 2-core x86-64 with AVX2; good to a factor of about 3 where the exact solver stays in double precision. What it
/// spends on chaotic or collapsing tuples is not predicted. To calibrate: run_time against predicted_time in /timings.
struct Coefficients {
  double start = 0.8e-6;              ///< any tuple: reducing the column, summing up
  double wave = 1.5;                  ///< fixed step: duration of the wave in tc per bead (t_k is about N tc)
  double hard_collision = 0.12e-6;    ///< ed: a collision
  double hard_collision_bead = 3e-9;  ///< ed: a collision, each bead
  double unequal = 1.5;               ///< soft: times equal beads
  double tc_rule = 1.5;               ///< ed: times the rule lrv
};
constexpr Coefficients cost;

/// The same for the exact solvers.
struct Exact {
  double dense_bead;      ///< the wave through the touching column, each bead
  double dense_pair;      ///< the same, each bead for each bead that moves with it
  double contact;         ///< a contact that overlaps no other in time
  double shared_contact;  ///< a contact that overlaps others, each bead
};
constexpr Exact linear{0.6e-6, 0.35e-6, 0.2e-6, 40e-9}, nonlinear{100e-6, 8e-6, 70e-6, 1e-6};

/// A step of a fixed-step scheme, and each bead of it, s; in the order of Integrator.
struct Step {
  double step, bead;
};
constexpr std::array<Step, 4> steps{{{0.0, 0.0}, {20e-9, 5e-9}, {20e-9, 2e-9}, {50e-9, 8e-9}}};

/// A lattice: what is in contact is moved by steps, in all directions; what flies costs nothing but with fixed steps.
/// Good to a factor of 3 for 8 to 1600 beads; 10^4 take five times as long.
struct LatticeCoefficients {
  double bead_row = 80e-6;      ///< exact: a bead, each row, for the contacts are so long or so many; in two runs
  double bead_period = 0.4e-3;  ///< exact: a bead, each period of the plate
  double fixed_bead = 40e-9;    ///< fixed step: a bead, each evaluation of the forces
  double wave_row = 3.0;        ///< fixed step: duration of the wave in tc, each row
  double least = 30.0;          ///< fixed step: duration in tc, beside wave and the quiet time at the end, 2 N sigma
};
constexpr LatticeCoefficients lattice;
constexpr std::array<double, 4> evaluations{0.0, 1.0, 1.0, 4.0};  ///< of the forces a step, in the order of Integrator

/// Contacts apart from the wave: for sigma above 1 all N^2 of hard spheres (N(N+1)/2 without losses); for sigma << 1
/// the beads fly apart after the wave and hardly meet again.
double later_contacts(double N, double sigma) { return N * N * sigma * sigma / (0.3 + sigma * sigma); }

double exact_time(double N, double sigma, const Exact& law) {
  const double wave = N * (law.dense_bead + law.dense_pair * N) / (1.0 + sigma);
  const double shared = N / (N + sigma);  // share of the contacts that overlap others: N of them in a time sigma
  return wave + later_contacts(N, sigma) * (law.contact + law.shared_contact * N * shared);
}

/// Free flight is not stepped through: the duration is that of the wave and of the later contacts, tc each.
/// The error of the schemes is about 0.03/steps_per_tc. Trials with longer steps cost little beside the last.
double steps_of(const Parameters& p) {
  return p.steps_per_tc > 0.0 ? p.steps_per_tc : std::clamp(0.03 / p.tolerance, 20.0, 1e6);
}

double fixed_step_time(double N, double sigma, double steps_per_tc, const Step& step) {
  const double duration = cost.wave * N + later_contacts(N, sigma);
  return steps_per_tc * duration * (step.step + step.bead * N);
}

/// Contacts a period go about with N^2, from a third (loose) to twice that (clustered). Steps are not skipped, and are
/// three times as dear as those of a collision, with the books that are kept.
double vibrated_time(const Parameters& p, double N) {
  const auto periods = static_cast<double>(p.periods);
  if (p.method == Method::ed) return 2e-6 * periods * N * N;
  if (p.integrator == Integrator::exact) return (exponents(p).linear() ? 12e-6 : 120e-6) * periods * N * N;
  const Step& step = steps[static_cast<std::size_t>(p.integrator)];
  return 3.0 * (step.step + step.bead * N) * p.steps_per_tc * periods / (p.frequency * p.tc);
}

double lattice_time(const Parameters& p, double N, double sigma) {
  const double rows = static_cast<double>(p.rows), periods = static_cast<double>(p.periods);
  const double exact = N * (is_vibrated(p) ? lattice.bead_period * periods : lattice.bead_row * rows);
  if (p.integrator == Integrator::exact) return exact;
  const double step = lattice.fixed_bead * N * evaluations[static_cast<std::size_t>(p.integrator)] * steps_of(p);
  if (is_vibrated(p)) return step * periods / (p.frequency * p.tc);
  return exact + step * (lattice.wave_row * rows + 2.0 * N * sigma + lattice.least);
}

}  // namespace

double predicted_time(const Parameters& p) {
  const double N = static_cast<double>(p.N);
  const double sigma = p.sigma < 1e12 ? p.sigma : 1e12;  // no inf/inf, no NaN; nothing changes up there
  if (is_lattice(p)) return cost.start + lattice_time(p, N, sigma);
  if (is_vibrated(p)) return cost.start + vibrated_time(p, N);
  if (p.method == Method::ed) {
    const double rule = p.ed_rule == EdRule::tc ? cost.tc_rule : 1.0;
    return cost.start + rule * N * N * (cost.hard_collision + cost.hard_collision_bead * N);
  }
  const double harder = p.width > 0.0 ? cost.unequal : 1.0;
  const double exact = cost.start + harder * exact_time(N, sigma, exponents(p).linear() ? linear : nonlinear);
  if (p.integrator == Integrator::exact) return exact;
  // The exact solution comes with it: it is what the error is measured against.
  return exact + fixed_step_time(N, sigma, steps_of(p), steps[static_cast<std::size_t>(p.integrator)]);
}

}  // namespace sigmasweep
