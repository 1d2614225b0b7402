#include "numerics/double_double.hpp"
#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<DoubleDouble, 2, false>;
template class ExactColumn<DoubleDouble, 2, true>;

}  // namespace sigmasweep
