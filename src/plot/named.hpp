#pragma once

#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The plot with this name. Throws UsageError with the names that there are.
const PlotSpec& plot_named(const std::vector<PlotSpec>& plots, const std::string& name);

/// The file of a spec's further plot: "dir/beads-NAME.svg" where the first plot is "dir/beads.svg".
std::string picture_named(const std::string& file, const std::string& name);

}  // namespace sigmasweep
