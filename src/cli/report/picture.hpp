#pragma once

#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {

/// Draws a plot of a table into a file, whose ending chooses the form. The title says when rows are still to come.
/// Returns the table of its fits as text; empty if it has none. Throws as plot_rows() and plot_films().
std::string draw_picture(const StoredSweep& stored, const std::string& table, PlotSpec spec, const std::string& file);

}  // namespace sigmasweep
