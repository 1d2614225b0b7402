#include "cli/processor/built_for.hpp"

namespace sigmasweep {

#ifdef __AVX512F__
const bool built_for_avx512 = true;
#else
const bool built_for_avx512 = false;
#endif

}  // namespace sigmasweep
