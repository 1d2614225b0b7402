#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<long double, 0, false>;
template class ExactColumn<long double, 1, false>;
template class ExactColumn<long double, 0, true>;
template class ExactColumn<long double, 1, true>;

}  // namespace sigmasweep
