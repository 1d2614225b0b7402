#pragma once

#include <cstddef>

#include "sigmasweep/model/fields.hpp"
#include "sweep/axis.hpp"
#include "sweep/spec/entry.hpp"

namespace sigmasweep::spec {

/// One parameter of [sweep] as given.
struct Setting {
  Entry entry;
  const ParameterField* field;
  Axis axis;             ///< one value if it is no axis
  bool is_axis = false;  ///< a list, a range or a sample, however short
  bool is_sobol = false;
};

/// Reads a parameter in any of its forms: value, list, range or sample. `sobol_dimension` is used if it is a Sobol
/// sample. Throws SpecError if it or any of its values is not allowed.
Setting read_setting(const Entry& entry, const ParameterField& field, std::size_t sobol_dimension);

}  // namespace sigmasweep::spec
