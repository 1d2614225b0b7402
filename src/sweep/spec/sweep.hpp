#pragma once

#include <optional>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sweep/grid.hpp"
#include "sweep/selection.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep::spec {

/// The table [sweep].
struct Grid {
  ParameterGrid product;
  std::vector<const ParameterField*> given;  ///< parameters in [sweep], in spec order
  std::vector<const ParameterField*> axes;   ///< parameters that are axes, in spec order
  std::vector<std::uint64_t> axis_sizes;
  std::vector<Parameters> representatives;  ///< see representative_tuples()
  std::optional<Selection> selection;       ///< indices of the product that satisfy `where`
};

/// Reads the table [sweep]. Nothing if `keys_alone` are to be checked, each by itself. Throws SpecError.
std::optional<Grid> read_sweep(const Entry& sweep, bool keys_alone);
/// The keys of [sweep] that are not parameters.
std::vector<KeyInfo> keys_of_sweep();

}  // namespace sigmasweep::spec
