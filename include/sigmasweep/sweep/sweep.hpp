#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/sweep/fields.hpp"
#include "sigmasweep/sweep/row.hpp"

namespace sigmasweep {

/// [plot] of a spec.
struct PlotSpec {
  std::string x = "sigma", y = "eps_eff";
  bool x_log = true, y_log = false;
  std::vector<std::string> series;  ///< names of fields: one curve per distinct combination
  std::string title;                ///< empty: the sweep's title
};

/// Whether the manager rank also computes. automatic: yes, unless there are many ranks.
enum class ManagerRole { automatic, computes, dedicated };

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
/// v0, tc, N, epsilon and one of s0 and sigma must be given, everything else has the defaults of Parameters. Where all
/// tuples are hard spheres tc may be left out: their contact time is zero, and the default only gives sigma its unit.
/// A parameter that no tuple uses (steps_per_tc without a fixed-step integrator, ...) is an error. `zip` names groups
/// of axes that advance together, `where` a condition on the parameters (see Where). geometry = "column" and
/// law = "hooke" are the only ones.
///
/// Index -> tuple is arithmetic: up to 2^40 tuples cost no memory. With `where` up to 2^26 tuples (fewer if it is
/// longer than 64 characters) are looked at when the spec is read, and one bit each is kept.
class Sweep {
 public:
  /// From TOML text; `file` is only for messages. Throws SpecError with one message: file, line, key, value, what is
  /// allowed and the nearest known key.
  static Sweep parse(std::string_view text, const std::string& file);
  /// From a file of at most 4 MiB. Throws InputNotFound or SpecError.
  static Sweep load(const std::string& path);

  const std::string& title() const;
  const std::string& text() const;       ///< the spec's whole text
  std::uint64_t hash() const;            ///< xxh3 of the text
  const PlotSpec& plot() const;
  ManagerRole manager() const;

  std::uint64_t size() const;            ///< number of rows, at least 1
  /// Parameters of a row, s0 and sigma both filled in. Throws std::out_of_range. Safe from several threads at once.
  Parameters at(std::uint64_t row) const;
  /// Names of the parameters that are axes, in spec order.
  const std::vector<std::string>& axes() const;
  /// How many values each of them takes, in the same order.
  const std::vector<std::uint64_t>& axis_sizes() const;
  /// What /results holds: the fixed members (v0, tc, s0, sigma, N, epsilon, method), other parameters that are axes,
  /// then the results.
  const std::vector<Field>& columns() const;

 private:
  struct Impl;
  explicit Sweep(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

/// Hash of what defines a row: the parameters to the bit (padding excluded) and the physics version.
std::uint64_t content_key(const Parameters& parameters);

}  // namespace sigmasweep
