#pragma once

namespace sigmasweep {

/// Whether the program was built for processors with AVX-512 only.
extern const bool built_for_avx512;

}  // namespace sigmasweep
