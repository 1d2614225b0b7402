#pragma once

#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// The maps of a stability study, for its text and picture: stability of schemes of fixed step by theory
/// (solve/fixed_step/stability.hpp) and in the rows of a table.
namespace sigmasweep {

/// The outcome of a row: |error of eps_eff| below 1 %, below 10 %, above; unstable; or no result for other reasons.
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

/// The maps of the rows that satisfy plot.where: one for each combination of the axes other than plot.y and
/// steps_per_tc, in the order of the rows. Throws UsageError.
std::vector<StabilityMap> stability_maps(std::span<const Row> rows, const PlotSpec& plot,
                                         std::span<const std::string> axes);

/// The first map among a spec's plots, or one with defaults.
PlotSpec stability_plot(std::span<const PlotSpec> plots);

/// The parameter plot.y. Throws UsageError if it is not a parameter.
const Field& stability_axis(const PlotSpec& plot);

}  // namespace sigmasweep
