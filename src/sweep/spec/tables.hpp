#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/grid.hpp"
#include "sweep/selection.hpp"
#include "sweep/spec/entry.hpp"

/// The tables of a spec. All throw SpecError.
namespace sigmasweep::spec {

struct Grid {
  ParameterGrid product;
  std::vector<const ParameterField*> axes;  ///< parameters that are axes, in spec order
  std::vector<std::uint64_t> axis_sizes;
  std::vector<Parameters> representatives;  ///< see representative_tuples()
  std::optional<Selection> selection;       ///< of the product's indices, if there is a `where`
};

Grid read_sweep(const Entry& sweep);
/// What is plotted where a spec does not say it.
PlotSpec usual_plot(const Grid& grid);
std::vector<PlotSpec> read_plots(const Entry& plot, const PlotSpec& usual);
RunSpec read_run(const Entry& run);
/// With the rows that it chooses.
TrajectorySpec read_trajectory(const Entry& trajectory, const Sweep& sweep);

}  // namespace sigmasweep::spec
