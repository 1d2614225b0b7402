#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<long double, 0, false>;
template class ExactColumn<long double, 2, false>;
template class ExactColumn<long double, 0, true>;
template class ExactColumn<long double, 2, true>;

}  // namespace sigmasweep
