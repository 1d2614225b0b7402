#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<double, 0, false>;
template class ExactColumn<double, 2, false>;
template class ExactColumn<double, 0, true>;
template class ExactColumn<double, 2, true>;
template Outcome<double> ExactColumn<double, 0, false>::run(Samples&);
template Outcome<double> ExactColumn<double, 0, true>::run(Samples&);

}  // namespace sigmasweep
