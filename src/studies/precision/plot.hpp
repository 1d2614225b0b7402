#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sigmasweep/model/row.hpp"
#include "studies/precision/study.hpp"

namespace sigmasweep {

/// Largest number of scenes in a picture.
inline constexpr std::size_t max_precision_panels = 64;

/// Draws time against error, log-log: a panel for each scene, a curve for each integrator, the references' noise as a
/// vertical line, settings with failures as crosses at the right border. Throws as plot_rows() does, and UsageError for
/// more than max_precision_panels scenes.
void plot_precision(std::span<const PrecisionRow> rows, std::span<const std::string> axes, const std::string& title,
                    const std::string& path);

/// Draws the rows of an ordinary table in the same way: run_time against eps_eff_error, in one panel, with a series for
/// each integrator and each value of its setting. Rows without a result are crosses at the right border.
void plot_precision_of(std::span<const Row> rows, const std::string& title, const std::string& path);

}  // namespace sigmasweep
