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
}

class Sweep;

/// A table of the spec that is not the sweep's own, such as a study's. The sweep keeps it, its owner reads it.
struct SpecSection {
  std::string_view name;
  /// Throws SpecError if the table is not what its owner can read, or the sweep not what it can use.
  void (*require_valid)(const spec::Entry& table, const Sweep& sweep);
};

/// A sweep spec, parsed and validated once; immutable. Rows are numbered in spec order, last axis fastest, after
/// `where`.
///
/// [sweep] gives each parameter as a value or as an axis:
///     [1.0, 2.0, 5.0]                                     a list
///     { from, to, count, scale = "linear" | "log" }       a range, both ends included
///     { sample = "uniform" | "log-uniform" | "sobol" | "latin-hypercube", from, to, count, seed, scale }
/// Samples depend on the seed (default 0) and the parameter's name only. Sobol axes that are zipped are dimensions of
/// one sequence; a seed other than 0 shifts it (digitally). `scale` also makes sobol and latin-hypercube logarithmic.
/// Whole numbers (N): a linear range must land on them, a logarithmic one is rounded and drops what repeats.
///
/// Enumerations (method, law, ...) are names, random_separation is true or false.
///
/// v0, N and one of s0 and sigma must be given, of vibrated columns N and one of alpha and A0 (s0 is 0 unless given, v0
/// only counts for laws that are not linear), of lattices rows instead of N; and stiffness and damping in one of three
/// ways: tc and epsilon; K_over_m and D_n (default 0); material = "steel" | "aluminium", which has its own d, too. With
/// the last two tc and epsilon follow at each v0. Everything else has the defaults of Parameters, but law = "power"
/// needs beta and gamma. With a tolerance and without steps_per_tc the integrators of fixed step choose their step
/// (steps_per_tc = 0). Where all tuples are hard spheres with ed_rule = "lrv" tc may be left out: their contact time is
/// zero, and the default only gives sigma its unit. A parameter that no tuple uses (steps_per_tc without a fixed-step
/// integrator, a seed where nothing is random, ...; see usage.hpp) is an error. So is a pair that is too damped to come
/// apart, but in very large sweeps only where an axis has its extremes; elsewhere its row fails. `zip` names groups of
/// axes that advance together, `where` a condition on the parameters (see Where).
///
/// Index -> tuple is arithmetic: up to 2^40 tuples cost no memory. With `where` up to 2^26 tuples (fewer if it is
/// longer than 64 characters; 2^17 if there are more than 2^13 different nonlinear pairs of a given stiffness) are
/// looked at when the spec is read, and one bit each is kept.
class Sweep {
 public:
  using Sections = std::span<const SpecSection>;

  /// From TOML text; `file` is only for messages, `sections` are the tables that it may have beside the sweep's own.
  /// Throws SpecError with one message: file, line, key, value, what is allowed and the nearest known key.
  static Sweep parse(std::string_view text, const std::string& file, Sections sections = {});
  /// From a file of at most 4 MiB. Throws InputNotFound or SpecError.
  static Sweep load(const std::string& path, Sections sections = {});
  /// From the text that a table keeps, which was checked before it was computed: sections of any name may be there.
  static Sweep parse_stored(std::string_view text, const std::string& file);

  const std::string& title() const;
  const std::string& text() const;  ///< the spec's whole text
  std::uint64_t hash() const;       ///< xxh3 of the text
  /// At least one. The first is the main one: [plot], or of several [[plot]] the one without a name, or the first.
  const std::vector<PlotSpec>& plots() const;
  ManagerRole manager() const;
  /// CPU time after which a tuple is given up, s, if the spec says so. Not part of what a tuple is.
  std::optional<double> tuple_time_limit() const;
  const std::optional<TrajectorySpec>& trajectory() const;  ///< if the spec has one
  /// The spec's table of that name that is not the sweep's own, or null. Valid as long as any copy of this sweep is.
  const spec::Entry* section(std::string_view name) const;

  std::uint64_t size() const;  ///< number of rows, at least 1
  /// Parameters of a row, s0 and sigma both filled in. Throws std::out_of_range. Safe from several threads at once.
  Parameters at(std::uint64_t row) const;
  /// Names of the parameters that are axes, in spec order.
  const std::vector<std::string>& axes() const;
  /// How many values each of them takes, in the same order.
  const std::vector<std::uint64_t>& axis_sizes() const;
  /// What /results holds: the fixed members (v0, tc, s0, sigma, N, epsilon, method; of what vibrates tc where there
  /// is one, N, epsilon, method, frequency, alpha, A0, periods; of lattices rows and columns, too), other parameters
  /// that are axes, then the results.
  const std::vector<Field>& columns() const;

 private:
  struct Impl;
  static Sweep parse(std::string_view text, const std::string& file, Sections sections, bool any_section);
  explicit Sweep(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

/// Hash of what defines a row: the parameters to the bit (padding excluded) and the physics version.
std::uint64_t content_key(const Parameters& parameters);

}  // namespace sigmasweep
