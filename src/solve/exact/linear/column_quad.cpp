#include "base/quad.hpp"
#include "solve/exact/linear/column_impl.hpp"

namespace sigmasweep {

template class ExactColumn<Quad, 0, false>;
template class ExactColumn<Quad, 2, false>;
template class ExactColumn<Quad, 0, true>;
template class ExactColumn<Quad, 2, true>;

}  // namespace sigmasweep
