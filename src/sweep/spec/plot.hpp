#pragma once

#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep::spec {

/// The plot of a spec without [plot], and the defaults of [plot].
PlotSpec usual_plot(const std::vector<Parameters>& representatives);
/// Reads [plot], one or several. Throws SpecError.
std::vector<PlotSpec> read_plots(const Entry& plot, const PlotSpec& usual);
std::vector<KeyInfo> keys_of_plot();

}  // namespace sigmasweep::spec
