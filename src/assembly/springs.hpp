#pragma once

#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

/// The parameters with the K_over_m and D_n that soft spheres are computed with: where they are not given, from tc and
/// epsilon at v0. They are for people and files; a tuple with them is another tuple. Hard spheres have neither, and
/// theirs stay as they are.
Parameters with_springs(Parameters parameters);

}  // namespace sigmasweep
