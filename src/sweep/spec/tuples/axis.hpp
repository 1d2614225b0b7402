#pragma once

#include <cstddef>
#include <string>
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
  std::string expression{};  ///< of a parameter that depends on others; the axis has the ends of its values then
};

/// The key `sample` of [sweep]: one sample of several parameters, each with its own interval or distribution.
struct JointSample {
  Entry entry;
  std::size_t method = 0;  ///< 0 uniform, 1 sobol, 2 latin-hypercube
  std::uint64_t count = 0, seed = 0;
  std::vector<std::string> of{};
};
JointSample read_joint_sample(const Entry& entry);

/// Reads a parameter: a value, expression, list, range or sample. `sobol_dimension` is the dimension of a Sobol sample,
/// `joint` the sample that the parameter belongs to, or null. Throws SpecError if a key or a value is not allowed.
Setting read_setting(const Entry& entry, const ParameterField& field, std::size_t sobol_dimension,
                     const JointSample* joint);
/// Reads a value: a number, a name or a truth. Throws SpecError.
AnyNumber read_value(const Entry& entry, const ParameterField& field);

/// The keys of a range or a sample, and of a joint sample.
std::vector<KeyInfo> keys_of_axis();
std::vector<KeyInfo> keys_of_joint_sample();

}  // namespace sigmasweep::spec
