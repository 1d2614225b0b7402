#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "sigmasweep/sweep/plot_spec.hpp"
#include "sigmasweep/sweep/run_spec.hpp"
#include "sigmasweep/sweep/trajectory_spec.hpp"

namespace sigmasweep {

namespace spec {
struct Entry;
struct KeyInfo;
}  // namespace spec

class Sweep;

/// A table of the spec that belongs to a study. The sweep keeps it for the study, which reads it.
struct SpecSection {
  std::string_view name;
  std::string_view meaning;              ///< one line
  std::vector<spec::KeyInfo> (*keys)();  ///< its keys, as help and the JSON schema show them
  /// Throws SpecError if the study cannot read the table or cannot use the sweep.
  void (*require_valid)(const spec::Entry& table, const Sweep& sweep);
};

/// A sweep spec, parsed, validated and immutable. Rows that satisfy `where` are numbered in spec order, the last axis
/// fastest; of several [[sweep]] the rows of one come after those of the other. Keys of [defaults] belong to each
/// [[sweep]] that does not have them itself and whose tuples use them.
///
/// The table [sweep] gives each parameter as a value, as an expression of other parameters (s0 = "0.01*d"), or as an
/// axis:
///     [1.0, 2.0, 5.0]                                     a list
///     { from, to, count, scale = "linear" | "log" }       a range, both ends included
///     { sample = "uniform" | "log-uniform" | "sobol" | "latin-hypercube", from, to, count, seed, scale }
///     { sample = "normal" | "log-normal", mean, sd, from, to, count, seed }   cut off at from and to, if given
/// A sample depends on the seed (default 0) and the parameter's name only. Zipped Sobol axes are dimensions of one
/// sequence; a seed other than 0 shifts it digitally. `scale` also makes sobol and latin-hypercube logarithmic. For
/// whole numbers (N) a linear range must consist of whole numbers; a logarithmic range is rounded, without repetitions.
/// Values of enumerations (method, law, ...) are names; random_separation is true or false. `zip` names groups of axes
/// that advance together, `sample = { method, of, count, seed }` samples several parameters together, `points` names a
/// CSV file whose columns are parameters that advance together, `where` is a condition on the parameters (see Where).
///
/// Parameters that must be given:
/// - v0, N (rows for a lattice), and s0 or sigma. On a plate v0 is needed for nonlinear laws only, and instead of the
///   gap, whose default is 0, alpha or A0 is needed.
/// - Stiffness and damping in one of three ways: tc and epsilon; K_over_m and D_n (default 0); or material, which has
///   its own d. The last two determine tc and epsilon at each v0. Hard spheres with ed_rule = "lrv" need no tc, which
///   only gives sigma its unit.
/// - beta and gamma for law = "power".
/// All others have the defaults of Parameters. An integrator of fixed step with a tolerance and without steps_per_tc
/// chooses its step (steps_per_tc = 0).
///
/// A parameter that no tuple uses is an error (see relevance.hpp), such as a seed if nothing is random. A pair that
/// never comes apart is an error, too; in very large sweeps only the extremes of axes are checked, and other such rows
/// fail.
///
/// A tuple is computed from its index, so that up to 2^40 tuples need no memory. `where` is evaluated when the spec is
/// read, and keeps one bit for each tuple. It can select from 2^26 tuples, from fewer if it is longer than 64
/// characters, and from 2^17 if there are more than 2^13 different pairs of nonlinear laws with given stiffness.
class Sweep {
 public:
  using Sections = std::span<const SpecSection>;

  /// Reads a spec from TOML text, which may have the tables `sections` beside the sweep's own. Messages name `file`.
  /// Throws SpecError with file, line, key, value, the allowed values and the nearest known key.
  static Sweep parse(std::string_view text, const std::string& file, Sections sections = {});
  /// Reads a spec from a file of at most 4 MiB. Each of `settings` is "KEY=VALUE" and replaces a key of [sweep]; text()
  /// has what was set, and the contents of the files of points. Throws InputNotFound, SpecError, or UsageError for a
  /// setting of another form.
  static Sweep load(const std::string& path, Sections sections = {}, std::span<const std::string> settings = {});
  /// Reads a spec from the text in a table. It may have sections of any name, because it was checked before the run.
  static Sweep parse_stored(std::string_view text, const std::string& file);

  const std::string& title() const;
  const std::string& text() const;  ///< the spec's whole text
  std::uint64_t hash() const;       ///< xxh3 of the text
  /// The plots, at least one. The first one is [plot], or of several [[plot]] the one without a name, or the first.
  const std::vector<PlotSpec>& plots() const;
  ManagerRole manager() const;
  /// CPU time after which a tuple is given up, s, if the spec has a limit.
  std::optional<double> tuple_time_limit() const;
  const std::optional<TrajectorySpec>& trajectory() const;
  /// The section of this name, or null. It is valid as long as any copy of this sweep.
  const spec::Entry* section(std::string_view name) const;

  std::uint64_t size() const;  ///< number of rows, at least 1
  /// The complete parameters of a row. Throws std::out_of_range. Several threads may call it at once.
  Parameters at(std::uint64_t row) const;
  /// Number of tables [[sweep]].
  std::size_t parts() const;
  /// Names of the parameters that are axes, or differ between several [[sweep]], in spec order.
  const std::vector<std::string>& axes() const;
  /// Number of values of each axis, in the same order; of several [[sweep]] the sum over them.
  const std::vector<std::uint64_t>& axis_sizes() const;
  /// The columns of /results: parameters that are axes or always columns (see FieldOf), then the results.
  const std::vector<Field>& columns() const;

 private:
  struct Impl;
  static Sweep parse(std::string_view text, const std::string& file, Sections sections, bool any_section);
  explicit Sweep(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

}  // namespace sigmasweep
