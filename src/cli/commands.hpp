#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/run.hpp"

/// What the program can do. Each command returns the exit code and throws Error; only one process calls it, but for
/// run.
namespace sigmasweep {

/// Starts MPI and runs the sweep, on all ranks.
int run_on_all_ranks(int& argc, char**& argv, const RunOptions& options);

struct MergeOptions {
  std::string output;
  std::vector<std::string> parts;
  bool fresh = false;  ///< replace what is there
  bool quiet = false;
};
/// Joins the tables of slices. Throws Error of code 65 where the parts do not fit together or rows are missing.
int merge(const MergeOptions& options);
/// The same on the manager, with MPI started for it on all ranks.
int merge_on_one_rank(int& argc, char**& argv, const MergeOptions& options);

struct PrecisionOptions {
  std::string spec, output;                      ///< output: the table; empty: default_table(spec)
  std::optional<std::uint64_t> tuples, repeats;  ///< instead of the spec's
  bool quiet = false, plots = true;
};
/// The precision study, on all ranks; exit codes as of run().
int precision(World& world, const PrecisionOptions& options);
/// The same, with MPI started for it.
int precision_on_all_ranks(int& argc, char**& argv, const PrecisionOptions& options);

struct StabilityOptions {
  RunOptions run;
  bool plots = true;
};
/// run(), then the map of stable steps, on all ranks; rows that came out unstable are no failures.
int stability(World& world, const StabilityOptions& options);
/// The same, with MPI started for it.
int stability_on_all_ranks(int& argc, char**& argv, const StabilityOptions& options);

struct PlanOptions {
  std::string spec;
  int ranks = 1;
  bool json = false;
};
int plan(const PlanOptions& options);

struct OneOptions {
  std::map<std::string_view, std::string> given;  ///< parameter: value as typed
  bool json = false;
};
int one(const OneOptions& options);

struct PlotOptions {
  std::string table, output;
  std::string name;  ///< of the one plot to draw; empty: all
  std::string kind;  ///< "precision": error against run time; "stability": map of stable steps; empty: as the spec says
  std::string x, y, x_scale, y_scale;  ///< instead of the spec's, where not empty; then one plot is drawn
  std::vector<std::string> series;
  bool quiet = false;  ///< the files' names only, no fits
};
int plot(const PlotOptions& options);

struct ShowOptions {
  std::string table, where;
  bool failed = false, json = false;
  std::optional<std::uint64_t> limit;  ///< of rows shown, 0: all; not given: default_limit, with json all
  static constexpr std::uint64_t default_limit = 40;
};
int show(const ShowOptions& options);

struct ExportOptions {
  std::string table, output;
  bool timings = false;
};
int export_csv(const ExportOptions& options);

}  // namespace sigmasweep
