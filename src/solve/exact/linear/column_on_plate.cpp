#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<double, 0, false, TaylorOrder<double>::value, Plate>;
template class ExactColumn<double, 0, true, TaylorOrder<double>::value, Plate>;

}  // namespace sigmasweep
