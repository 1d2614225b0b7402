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
  std::vector<const ParameterField*> axes;  ///< parameters that are axes, in spec order
  std::vector<std::uint64_t> axis_sizes;
  std::vector<Parameters> representatives;  ///< see representative_tuples()
  std::optional<Selection> selection;       ///< indices of the product that satisfy `where`
};

Grid read_sweep(const Entry& sweep);
/// The plot of a spec without [plot], and the defaults of [plot].
PlotSpec usual_plot(const Grid& grid);
std::vector<PlotSpec> read_plots(const Entry& plot, const PlotSpec& usual);
RunSpec read_run(const Entry& run);
/// The table [trajectory], with the rows of the sweep that satisfy its condition.
TrajectorySpec read_trajectory(const Entry& trajectory, const Sweep& sweep);

}  // namespace sigmasweep::spec
