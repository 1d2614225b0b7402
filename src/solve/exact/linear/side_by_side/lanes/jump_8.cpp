#include "solve/exact/linear/side_by_side/lanes/jump.hpp"
#include "solve/exact/linear/side_by_side/lanes/jump_impl.hpp"

namespace sigmasweep::side_by_side {

void jump(Jumps<8, false>& columns) { jump_columns<8>(columns); }
void jump(Jumps<8, true>& columns) { jump_columns<8>(columns); }

}  // namespace sigmasweep::side_by_side
