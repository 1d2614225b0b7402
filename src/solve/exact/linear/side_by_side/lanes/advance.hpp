#pragma once

#include "solve/exact/linear/side_by_side/lanes/columns.hpp"

namespace sigmasweep::side_by_side {

/// Every active column flies to its next contact if nothing touches, and goes on by a step, to the first event in it.
/// Each width is compiled for the instructions that it needs: 8 for x86-64-v4 (AVX-512), 4 and 1 for x86-64-v3 (AVX2,
/// FMA).
void advance(Columns<1, false>& columns);
void advance(Columns<1, true>& columns);
void advance(Columns<4, false>& columns);
void advance(Columns<4, true>& columns);
void advance(Columns<8, false>& columns);
void advance(Columns<8, true>& columns);

/// The widest that this processor has instructions for.
int widest();

}  // namespace sigmasweep::side_by_side
