#include "solve/exact/linear/side_by_side/lanes/advance.hpp"
#include "solve/exact/linear/side_by_side/lanes/advance_impl.hpp"

namespace sigmasweep::side_by_side {

void advance(Columns<1, false>& columns) { advance_columns<1>(columns); }
void advance(Columns<1, true>& columns) { advance_columns<1>(columns); }

}  // namespace sigmasweep::side_by_side
