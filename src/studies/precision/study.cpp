#include "studies/precision/study.hpp"

#include <array>

#include "sigmasweep/model/names.hpp"

namespace sigmasweep {

std::vector<Integrator> all_integrators() {
  constexpr auto all = values_of<Integrator>();
  return {all.begin(), all.end()};
}

std::span<const PrecisionField> precision_fields() {
#define SIGMASWEEP_AT(member) offsetof(PrecisionRow, member)
  static constexpr auto fields = std::to_array<PrecisionField>({
      {"scene", "1", "row of the sweep, from 0", false, SIGMASWEEP_AT(scene)},
      {"setting", "1", "steps_per_tc, or the tolerance of exact; nan: exact of what vibrates, which has none", true,
       SIGMASWEEP_AT(setting)},
      {"tuples", "1", "random contact phases computed; 0: left out, a tuple would take too long", false,
       SIGMASWEEP_AT(tuples)},
      {"failures", "1", "of these without a result, or with a tolerance missed", false, SIGMASWEEP_AT(failures)},
      {"compared", "1", "of these with a result and a reference: the errors are theirs", false,
       SIGMASWEEP_AT(compared)},
      {"error_median", "1", "absolute error of eps_eff, of what vibrates of h_cm/A0; median", true,
       SIGMASWEEP_AT(error_median)},
      {"error_99", "1", "the same, 99 % quantile", true, SIGMASWEEP_AT(error_99)},
      {"error_max", "1", "the same, largest", true, SIGMASWEEP_AT(error_max)},
      {"velocity_median", "v0", "error of the final velocities, largest of the beads, median; nan for what vibrates",
       true, SIGMASWEEP_AT(velocity_median)},
      {"velocity_max", "v0", "error of the final velocities, largest of the beads and tuples", true,
       SIGMASWEEP_AT(velocity_max)},
      {"run_time", "s", "CPU time a tuple, mean; the smallest of the repeats", true, SIGMASWEEP_AT(run_time)},
      {"evaluations", "1", "evaluations of all forces a tuple, mean; nan where they are not counted", true,
       SIGMASWEEP_AT(evaluations)},
      {"references", "1", "tuples of the scene with a reference", false, SIGMASWEEP_AT(references)},
      {"checks", "1", "of these computed by both references", false, SIGMASWEEP_AT(checks)},
      {"noise", "1", "largest difference between the references where they agree, as of error_median", true,
       SIGMASWEEP_AT(noise)},
      {"chaotic", "1", "of the checks: the references differ by more than 1e-9", false, SIGMASWEEP_AT(chaotic)},
      {"independent", "1", "1: references by two methods; 0: one method at two accuracies", false,
       SIGMASWEEP_AT(independent)},
      {"rank", "1", "MPI rank that measured", false, SIGMASWEEP_AT(rank)},
      {"ranks_per_core", "1", "most ranks that shared a processor", false, SIGMASWEEP_AT(ranks_per_core)},
  });
#undef SIGMASWEEP_AT
  return fields;
}

}  // namespace sigmasweep
