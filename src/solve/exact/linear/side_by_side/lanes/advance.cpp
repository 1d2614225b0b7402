#include "solve/exact/linear/side_by_side/lanes/advance.hpp"

namespace sigmasweep::side_by_side {

int widest() {
  static const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                                 __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                                 __builtin_cpu_supports("avx512vl");
  return has_avx512 ? 8 : 4;
}

}  // namespace sigmasweep::side_by_side
