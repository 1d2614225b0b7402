#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "python/given.hpp"

namespace sigmasweep::python {

/// Computes the tuples on some threads and pack()s the columns of each into `rows`. `interrupted` is asked ten times a
/// second on the calling thread; where it is true the rest is left out, and the result is false. Throws SpecError for a
/// tuple whose values are not allowed.
bool compute(std::span<const Given> given, std::size_t count, std::span<const Field> columns, std::span<std::byte> rows,
             int threads, const std::function<bool()>& interrupted);

}  // namespace sigmasweep::python
