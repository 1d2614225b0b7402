#pragma once

#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// The maps of a stability study, which text and picture show: where the schemes of fixed step are stable by theory
/// (solve/fixed_step/stability.hpp), and by the rows of a table.
namespace sigmasweep {

/// How a row ended: |error of eps_eff| below 1 %, below 10 %, above; unstable; or no result for other reasons.
enum class Observed { good, fair, wrong, unstable, nothing };

struct StabilityCell {
  double y = 0.0;
  double steps = 0.0;  ///< tc/dt
  Observed observed = Observed::nothing;
  bool predicted_stable = false;
};

struct StabilityLimit {
  double y = 0.0;
  double steps = 0.0;  ///< the smallest tc/dt that theory allows
};

struct StabilityMap {
  std::string label, plain_label;  ///< for gnuplot, and as text: the values of the other axes
  std::vector<StabilityCell> cells;
  std::vector<StabilityLimit> limits;  ///< by y, also between those of the cells
};

/// One map for each combination of the axes that are neither plot.y nor steps_per_tc, in the order of the rows; of the
/// rows that plot.where chooses. Throws UsageError.
std::vector<StabilityMap> stability_maps(std::span<const Row> rows, const PlotSpec& plot,
                                         std::span<const std::string> axes);

/// The first map among a spec's plots, or one with defaults.
PlotSpec stability_plot(std::span<const PlotSpec> plots);

/// The parameter that plot.y names. Throws UsageError for anything else.
const Field& stability_axis(const PlotSpec& plot);

}  // namespace sigmasweep
