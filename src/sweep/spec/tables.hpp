#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/grid.hpp"
#include "sweep/selection.hpp"
#include "sweep/spec/entry.hpp"

/// Readers of a spec's tables. All throw SpecError.
namespace sigmasweep::spec {

/// The table [sweep].
struct Grid {
  ParameterGrid product;
  std::vector<const ParameterField*> given;  ///< parameters in [sweep], in spec order
  std::vector<const ParameterField*> axes;   ///< parameters that are axes, in spec order
  std::vector<std::uint64_t> axis_sizes;
  std::vector<Parameters> representatives;  ///< see representative_tuples()
  std::optional<Selection> selection;       ///< indices of the product that satisfy `where`
};

/// Nothing if `keys_alone` are to be checked, each by itself.
std::optional<Grid> read_sweep(const Entry& sweep, bool keys_alone);
/// The plot of a spec without [plot], and the defaults of [plot].
PlotSpec usual_plot(const Grid& grid);
std::vector<PlotSpec> read_plots(const Entry& plot, const PlotSpec& usual);
RunSpec read_run(const Entry& run);
/// Checks the keys of the table [trajectory] and their values, but for the condition on rows.
void require_trajectory_keys(const Entry& trajectory);
/// The table [trajectory], with the rows of the sweep that satisfy its condition.
TrajectorySpec read_trajectory(const Entry& trajectory, const Sweep& sweep);

}  // namespace sigmasweep::spec
