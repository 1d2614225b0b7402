#include "solve/exact/linear/side_by_side/lanes/advance.hpp"

namespace sigmasweep::side_by_side {

int widest() {
  static const int width = __builtin_cpu_supports("x86-64-v4") ? 8 : 4;
  return width;
}

}  // namespace sigmasweep::side_by_side
