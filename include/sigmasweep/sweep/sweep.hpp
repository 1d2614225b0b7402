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

/// A sweep spec, parsed and validated once; immutable. Rows are numbered in spec order, last axis fastest, after `where`.
class Sweep {
 public:
  /// From TOML text; `file` is only for messages. Throws SpecError with one message: file, line, key, value, what is
  /// allowed and the nearest known key.
  static Sweep parse(std::string_view text, const std::string& file);
  /// From a file. Throws InputNotFound or SpecError.
  static Sweep load(const std::string& path);

  const std::string& title() const;
  const std::string& text() const;       ///< the spec's whole text
  std::uint64_t hash() const;            ///< xxh3 of the text
  const PlotSpec& plot() const;
  ManagerRole manager() const;

  std::uint64_t size() const;            ///< number of rows
  Parameters at(std::uint64_t row) const;
  /// Names of the parameters that are axes, in spec order.
  const std::vector<std::string>& axes() const;
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
