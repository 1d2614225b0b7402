#pragma once

#include <optional>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sweep/grid.hpp"
#include "sweep/selection.hpp"
#include "sweep/spec/entry.hpp"

namespace sigmasweep::spec {

/// A table [sweep]: all tuples of a spec, or one part of them.
struct Grid {
  ParameterGrid product;
  std::vector<const ParameterField*> given;  ///< parameters in [sweep], in spec order
  std::vector<const ParameterField*> axes;   ///< parameters that are axes, in spec order
  std::vector<std::uint64_t> axis_sizes;
  std::vector<Parameters> representatives;  ///< see representative_tuples()
  std::optional<Selection> selection;       ///< indices of the product that satisfy `where`
};

/// Number of tuples that are computed.
std::uint64_t size_of(const Grid& grid);

/// Reads a table [sweep], and the keys of [defaults] that it does not have itself and that its tuples use. Nothing if
/// `keys_alone` are to be checked, each by itself. Throws SpecError.
std::optional<Grid> read_part(const Entry& sweep, const std::vector<Entry>& defaults, bool keys_alone);

}  // namespace sigmasweep::spec
