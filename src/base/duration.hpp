#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sigmasweep {

/// A length of time, s: a number of seconds, or as Slurm writes it: MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS. Nothing
/// for anything else (Slurm's UNLIMITED, say).
std::optional<double> parse_duration(std::string_view text);

/// A length of time as people read it: "0.3 ms", "12 s", "3 min 20 s", "5 h 12 min".
std::string readable_duration(double seconds);

}  // namespace sigmasweep
