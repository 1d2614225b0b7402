#include "bench/peers/cvode_events.hpp"

namespace sigmasweep::peers {

std::vector<Method> cvode_methods() { return {}; }

}  // namespace sigmasweep::peers
