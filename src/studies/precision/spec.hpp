#pragma once

#include <optional>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "studies/precision/study.hpp"

/// The table [precision] of a spec.
namespace sigmasweep {

/// The sweep's rows are the study's scenes. Throws SpecError.
PrecisionSpec read_precision(const spec::Entry& table, const Sweep& sweep);

std::vector<spec::KeyInfo> keys_of_precision();

inline constexpr SpecSection precision_section{
    "precision", "scenes and settings of 'sigmasweep precision'", keys_of_precision,
    [](const spec::Entry& table, const Sweep& sweep) { read_precision(table, sweep); }};

/// The study of a sweep that was parsed with this section, if it has one.
std::optional<PrecisionSpec> precision_of(const Sweep& sweep);

}  // namespace sigmasweep
