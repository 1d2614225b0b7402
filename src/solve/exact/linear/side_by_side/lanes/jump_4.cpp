#include "solve/exact/linear/side_by_side/lanes/jump.hpp"
#include "solve/exact/linear/side_by_side/lanes/jump_impl.hpp"

namespace sigmasweep::side_by_side {

void jump(Jumps<4, false>& columns) { jump_columns<4>(columns); }
void jump(Jumps<4, true>& columns) { jump_columns<4>(columns); }

}  // namespace sigmasweep::side_by_side
