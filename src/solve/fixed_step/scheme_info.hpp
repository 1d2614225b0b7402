#pragma once

#include <span>

#include "sigmasweep/model/parameters.hpp"
#include "solve/fixed_step/schemes/scheme.hpp"

namespace sigmasweep {

/// The traits of a scheme of fixed step, for code that does not integrate with it: predicted run times, stability.
struct SchemeInfo {
  Integrator id;
  int evaluations;  ///< of the forces in a step
  StepCost cost;
  StepMap (*step_map)(const Mode& mode);
};

/// All schemes, in the order of their list.
std::span<const SchemeInfo> schemes();

/// The integrator's scheme. Throws std::invalid_argument where it has none (Integrator::exact).
const SchemeInfo& scheme_info(Integrator integrator);

}  // namespace sigmasweep
