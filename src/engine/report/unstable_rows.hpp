#pragma once

#include <cstdint>
#include <string>

#include "sigmasweep/sweep/sweep.hpp"

namespace sigmasweep {

/// One line on the rows whose time step theory says is too long (is_stable()): how many, and the scheme and step that
/// most of them have, with the range of epsilon. Empty if there are none. Of more than a million rows a sample of a
/// million is examined.
std::string stability_warning(const Sweep& sweep);

}  // namespace sigmasweep
