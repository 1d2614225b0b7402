#pragma once

#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The plot of that name. Throws UsageError with the known names.
const PlotSpec& plot_named(const std::vector<PlotSpec>& plots, const std::string& name);

/// "dir/beads-NAME.svg" from "dir/beads.svg": the files of a spec's further plots.
std::string picture_named(const std::string& file, const std::string& name);

}  // namespace sigmasweep
