#include "engine/run.hpp"

#include <fmt/format.h>
#include <charconv>
#include <optional>

#include "base/duration.hpp"
#include "cli/command.hpp"
#include "cli/settings_option.hpp"
#include "engine/stop/last_resort.hpp"
#include "studies/sections.hpp"

namespace sigmasweep {
namespace {

constexpr std::string_view time_help = "seconds or [D-]HH:MM:SS";

std::string time_complaint(const std::string& typed) {
  if (parse_duration(typed)) return {};
  return fmt::format("'{}' is not a time: give {}, such as 24:00:00 for 24 hours", typed, time_help);
}

constexpr std::uint64_t most_slices = 1'000'000;

/// Reads "3/8"; nothing for text of another form.
std::optional<Slice> parse_slice(const std::string& typed) {
  Slice slice;
  const char *begin = typed.data(), *end = begin + typed.size();
  const auto [slash, bad_index] = std::from_chars(begin, end, slice.index);
  if (bad_index != std::errc() || slash == end || *slash != '/') return std::nullopt;
  const auto [rest, bad_count] = std::from_chars(slash + 1, end, slice.count);
  if (bad_count != std::errc() || rest != end || slice.index >= slice.count || slice.count > most_slices)
    return std::nullopt;
  return slice;
}

std::string slice_complaint(const std::string& typed) {
  if (parse_slice(typed)) return {};
  return fmt::format(
      "'{}' is not a slice: give I/N with N up to {} and I from 0 to N - 1, the three slices of a sweep are 0/3, 1/3 "
      "and "
      "2/3",
      typed, most_slices);
}

void declare(OptionSet& set, RunOptions& options) {
  options.sections = study_sections;
  set.add({"spec", "The sweep spec, a TOML file", "SPEC.toml"}, options.spec);
  add_settings(set, options.settings);
  set.add({"-o,--output", "The table; default: the spec's name with .h5, in this directory", "TABLE.h5"},
          options.output);
  set.add_flag("--fresh", "Start again and replace an existing table or journal", options.fresh);
  set.add_flag("--retry", "Compute rows again that were given up: time_limit, quarantined", options.retry);
  set.add_flag("-q,--quiet", "Neither progress nor summary", options.quiet);
  set.add_flag("--json", "The summary as one JSON document on standard output; times in seconds", options.json);
  const auto take_time = [&options](const std::string& typed) {
    options.max_seconds = parse_duration(typed);
    if (options.max_seconds) LastResort::expect_stop_in(*options.max_seconds);  // MPI may not even begin
    return options.max_seconds.has_value();
  };
  set.add({.names = "--max-time",
           .meaning = fmt::format("Stop on purpose (exit code 75) within this time: {}", time_help),
           .type_name = "T",
           .complaint = time_complaint},
          take_time);
  set.add({.names = "--max-seconds", .meaning = "", .type_name = "T", .complaint = time_complaint, .hidden = true},
          take_time);
  set.add({.names = "--slice",
           .meaning = "Compute slice I (from 0) of N equal ones, for 'sigmasweep merge' to join",
           .type_name = "I/N",
           .complaint = slice_complaint},
          [&options](const std::string& typed) {
            const auto slice = parse_slice(typed);
            if (slice) options.slice = *slice;
            return slice.has_value();
          });
  set.add_flag("--extend", "Replace the table of an earlier spec, but take over rows that are the same",
               options.extend);
  set.add({"--reuse", "Take over rows that are the same from this table (may be repeated)", "OTHER.h5"}, options.reuse,
          Several::repeated);
}

}  // namespace

Command run_command() {
  return make_command(
      "run", "Run a sweep, or go on with it; alone or under mpirun",
      "\nA run that was stopped or killed goes on when it is started again with the same spec. Results do not depend\n"
      "on the number of ranks. In a Slurm job the run stops in time before the end of the job.\n\n"
      "  mpirun -n 4 sigmasweep run fig2a.toml -o fig2a.h5",
      declare, run);
}

}  // namespace sigmasweep
