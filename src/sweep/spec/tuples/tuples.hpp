#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/spec/tuples/contents.hpp"
#include "sweep/spec/tuples/part.hpp"

namespace sigmasweep::spec {

/// All tuples of a spec: those of [sweep], or of several [[sweep]] one after the other.
class Tuples {
 public:
  /// Throws SpecError. `defaults` is the table [defaults]; keys that no part uses are a mistake.
  Tuples(const Entry& sweep, const std::optional<Entry>& defaults);

  std::size_t parts() const { return parts_.size(); }
  std::uint64_t size() const { return ends_.back(); }
  Parameters at(std::uint64_t row) const;
  /// Parameters that are given in some part, and those that are axes or differ between parts; in spec order.
  const std::vector<const ParameterField*>& given() const { return given_; }
  const std::vector<std::string>& axes() const { return axes_; }
  /// Number of values of each axis; in several parts the sum over them.
  const std::vector<std::uint64_t>& axis_sizes() const { return axis_sizes_; }
  /// See representative_tuples().
  const std::vector<Parameters>& representatives() const { return representatives_; }

 private:
  void combine();

  std::vector<Grid> parts_;
  std::vector<std::uint64_t> ends_;  ///< one past the last row of each part
  std::vector<const ParameterField*> given_;
  std::vector<std::string> axes_;
  std::vector<std::uint64_t> axis_sizes_;
  std::vector<Parameters> representatives_;
};

/// Checks each key of [sweep] or of several [[sweep]] by itself. Throws SpecError.
void require_readable(const Entry& sweep, const std::optional<Entry>& defaults);

}  // namespace sigmasweep::spec
