#include "solve/exact/linear/side_by_side/lanes/advance.hpp"
#include "solve/exact/linear/side_by_side/lanes/advance_impl.hpp"

namespace sigmasweep::side_by_side {

void advance(Columns<8, false>& columns) { advance_columns<8>(columns); }
void advance(Columns<8, true>& columns) { advance_columns<8>(columns); }

}  // namespace sigmasweep::side_by_side
