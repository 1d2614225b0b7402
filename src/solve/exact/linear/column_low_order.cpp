#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

/// With short Taylor series, for loose tolerances.
template class ExactColumn<double, 2, false, low_order>;
template class ExactColumn<double, 2, true, low_order>;

}  // namespace sigmasweep
