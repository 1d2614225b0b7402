#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/sweep/sweep.hpp"

/// Tuples as Python gives them: each parameter by its name, as one number for all tuples or as one for each.
namespace sigmasweep::python {

/// Values of a parameter. Enumerators are given by their numbers.
struct Given {
  const ParameterField* field;
  std::variant<std::span<const double>, std::span<const std::int64_t>> values;  ///< one, or one a tuple
};

bool is_given(std::span<const Given> given, std::string_view name);

/// Tuple `k` of those given, not yet complete.
Parameters tuple_of(std::span<const Given> given, std::size_t k);

/// A sweep of those tuples that stand for all: one for each combination of enumerators, and of numbers that are 0 or
/// not, as far as combinations occur. It has the columns of the result. Throws SpecError, without places, for
/// parameters that are missing, unused or contradict each other.
Sweep representatives(std::span<const Given> given, std::size_t count);

}  // namespace sigmasweep::python
