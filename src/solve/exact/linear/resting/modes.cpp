#include "solve/exact/linear/resting/modes.hpp"

namespace sigmasweep {

Eigen::MatrixXcd inverse_of(const Eigen::MatrixXcd& V) { return V.inverse(); }

}  // namespace sigmasweep
