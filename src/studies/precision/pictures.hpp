#pragma once

#include <cstdio>
#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/study.hpp"

namespace sigmasweep {

/// Draws a study's plots of the spec, the first one into `file`, others into picture_named(); with `name` only that
/// one. Prints the files' names to `out`. Throws UsageError, also where a plot's `where` chooses no scene.
void draw_precision(const Sweep& sweep, std::span<const PrecisionRow> rows, const std::string& file,
                    const std::string& name, std::FILE* out);

/// Of a study that was stored.
void draw_stored_precision(const std::string& table, const std::string& file, const std::string& name);

}  // namespace sigmasweep
