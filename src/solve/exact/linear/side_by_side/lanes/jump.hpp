#pragma once

#include "solve/exact/linear/side_by_side/lanes/columns.hpp"

namespace sigmasweep::side_by_side {

/// Every active column flies to its next contact, which closes and, at once, opens again; see jump_impl.hpp. Lanes that
/// come to an end, or are crowded, are not active any more.
void jump(Jumps<1, false>& columns);
void jump(Jumps<1, true>& columns);
void jump(Jumps<4, false>& columns);
void jump(Jumps<4, true>& columns);
void jump(Jumps<8, false>& columns);
void jump(Jumps<8, true>& columns);

}  // namespace sigmasweep::side_by_side
