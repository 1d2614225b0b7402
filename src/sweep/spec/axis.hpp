#pragma once

#include <cstddef>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sweep/axis.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"

namespace sigmasweep::spec {

/// A parameter in [sweep].
struct Setting {
  Entry entry;
  const ParameterField* field;
  Axis axis;             ///< has one value if the parameter is not an axis
  bool is_axis = false;  ///< a list, a range or a sample of any length
  bool is_sobol = false;
};

/// Reads a parameter: a value, list, range or sample. `sobol_dimension` is the dimension of a Sobol sample. Throws
/// SpecError if a key or a value is not allowed.
Setting read_setting(const Entry& entry, const ParameterField& field, std::size_t sobol_dimension);

/// The keys of a range or a sample.
std::vector<KeyInfo> keys_of_axis();

}  // namespace sigmasweep::spec
