#pragma once

#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep::spec {

/// Checks the keys of the table [trajectory] and their values, but for the condition on rows. Throws SpecError.
void require_trajectory_keys(const Entry& trajectory);
/// The table [trajectory], with the rows of the sweep that satisfy its condition. Throws SpecError.
TrajectorySpec read_trajectory(const Entry& trajectory, const Sweep& sweep);
std::vector<KeyInfo> keys_of_trajectory();

}  // namespace sigmasweep::spec
