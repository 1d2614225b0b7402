#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/slice.hpp"

namespace sigmasweep {

struct RunOptions {
  std::string spec;                         ///< path of the sweep spec
  std::vector<std::string> settings{};      ///< "KEY=VALUE": keys of [sweep] that are replaced
  std::string output;                       ///< path of the table; empty: default_table(spec)
  bool fresh = false;                       ///< start again, whatever is there
  bool quiet = false;                       ///< neither progress nor summary
  bool json = false;                        ///< the summary as JSON on standard output
  std::optional<double> max_seconds;        ///< end within this time; the end of a Slurm job counts as well
  Slice slice;                              ///< compute these rows only
  bool extend = false;                      ///< take over the rows of the table of another spec that is to be replaced
  std::vector<std::string> reuse;           ///< tables whose rows are taken over
  bool retry = false;                       ///< compute rows again whose status is not reproducible
  std::span<const SpecSection> sections{};  ///< tables that the spec may have beside the sweep's own
};

/// The spec's name with .h5 for .toml, in the current directory; other dots belong to the name.
std::string default_table(const std::string& spec);
/// Throws UsageError for a spec that has no name of its own to call the table after: a pipe, or "-" for standard input.
void require_named_spec(const std::string& spec);

/// The table's name with this ending for .h5 or .hdf5: that of its picture, say.
std::string named_after(const std::string& table, const std::string& ending);

}  // namespace sigmasweep
