#pragma once

#include <span>
#include <string>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// The maps of stable steps as text: for each y the longest step up to which all rows are stable, the shortest one that
/// is not, and the limit that theory predicts; and on how many rows theory and collision agree. Throws UsageError.
std::string stability_text(std::span<const Row> rows, const PlotSpec& plot, std::span<const std::string> axes);

}  // namespace sigmasweep
