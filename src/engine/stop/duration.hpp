#pragma once

#include <optional>
#include <string_view>

namespace sigmasweep {

/// A length of time, s: a number of seconds, or as Slurm writes it: MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS. Nothing
/// for anything else (Slurm's UNLIMITED, say).
std::optional<double> parse_duration(std::string_view text);

}  // namespace sigmasweep
