#pragma once

#include <string_view>

#include "studies/precision/cases/precision_case.hpp"

namespace sigmasweep {

/// A kind of scenes, with the same quantity and the same methods of measurement.
struct SceneKind {
  std::string_view quantity;  ///< the result whose error is measured
  bool exact_has_tolerance;   ///< the integrator `exact` can be set
  /// The predicted cost of fixed steps includes the exact solution, which a sweep computes for the error bar, but a
  /// study does not.
  bool fixed_steps_have_reference;
  PrecisionCase (*make)(const Parameters& scene, const PrecisionSpec& spec);
};

const SceneKind& scene_kind(const Parameters& scene);

}  // namespace sigmasweep
