#pragma once

#include <string_view>

#include "studies/precision/cases/precision_case.hpp"

namespace sigmasweep {

/// How scenes of a geometry are measured.
struct SceneKind {
  std::string_view quantity;  ///< the result whose error is measured
  bool exact_has_tolerance;   ///< the integrator `exact` can be set
  /// With fixed steps a sweep computes the exact solution as well, for the error bar: its cost is part of the predicted
  /// one, but not of the study's.
  bool fixed_steps_have_reference;
  PrecisionCase (*make)(const Parameters& scene, const PrecisionSpec& spec);
};

const SceneKind& scene_kind(const Parameters& scene);

}  // namespace sigmasweep
