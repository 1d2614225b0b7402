#pragma once

#include <cstdio>
#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/study.hpp"

namespace sigmasweep {

/// Draws the spec's plots of a study, the first one into `file`, others into picture_named(); with `name` only this
/// one. Prints the files' names to `out`. Throws UsageError, also if no scene satisfies a plot's `where`.
void draw_precision(const Sweep& sweep, std::span<const PrecisionRow> rows, const std::string& file,
                    const std::string& name, std::FILE* out);

/// Draws the plots of a stored study.
void draw_stored_precision(const std::string& table, const std::string& file, const std::string& name);

}  // namespace sigmasweep
