#pragma once

#include <span>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

/// The reference of specs and tables as Markdown, made from the registries of keys and fields.
namespace sigmasweep {

/// Every key of a spec that may have the tables `sections` beside the sweep's own, and every field of a row.
std::string spec_reference(std::span<const SpecSection> sections);
/// The keys of [plot] alone.
std::string plot_reference();
/// The fields of a row: parameters, results and timings.
std::string field_reference();

}  // namespace sigmasweep
