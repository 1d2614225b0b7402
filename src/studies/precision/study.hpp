#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"

/// A precision study: the error of integrators against their computing time.
namespace sigmasweep {

/// exact and all schemes of fixed step.
std::vector<Integrator> all_integrators();

/// The section [precision] of a spec. A scene is a row of [sweep], which has neither integrators nor their settings.
///
///     integrators  = ["exact", "gear5", "verlet", "rk4"]  # default: all there are
///     steps_per_tc = [20, 50, 100, 200, 500, 1000]        # of the integrators of fixed step: dt = tc/steps_per_tc
///     tolerances   = [1e-3, 1e-6, 1e-9, 1e-13]            # of exact
///     tuples  = 400   # random contact phases of a scene
///     checks  = 20    # number of tuples with both references
///     repeats = 5     # number of timings; the smallest counts
///     seconds = 0.1   # CPU time for the tuples of one setting, or for the references, s
///     repeat_seconds = 1   # a setting that has taken longer, s, is not timed again
///     longest = 0.5   # largest CPU time of a tuple, s; slower settings are left out
///     seed    = 0
struct PrecisionSpec {
  std::vector<Integrator> integrators = all_integrators();
  std::vector<double> steps_per_tc{20, 50, 100, 200, 500, 1000}, tolerances{1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
  std::uint64_t tuples = 400, checks = 20, repeats = 5, seed = 0;
  double seconds = 0.1, repeat_seconds = 1.0, longest = 0.5;
};

/// The measurements of one setting of one integrator in one scene. A plain value of fixed size, which is sent between
/// ranks and stored as it is. NaN: not known.
struct PrecisionRow {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t scene = 0;
  Parameters parameters;  ///< of the scene, with integrator and setting
  double setting = nan;   ///< steps_per_tc or tolerance; NaN for exact on a plate
  std::uint64_t tuples = 0, failures = 0, compared = 0, references = 0;
  double error_median = nan, error_99 = nan, error_max = nan;
  double velocity_median = nan, velocity_max = nan;
  double run_time = nan, evaluations = nan;
  double noise = nan;
  std::uint64_t checks = 0, chaotic = 0, independent = 0;
  std::int64_t rank = -1, ranks_per_core = 1;
};

/// A column of the study's table, after the parameters of the scene.
struct PrecisionField {
  std::string_view name, unit, meaning;
  bool real;
  std::size_t offset;  ///< within PrecisionRow; a double or 64-bit whole number
};
std::span<const PrecisionField> precision_fields();

}  // namespace sigmasweep
