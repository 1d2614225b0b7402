#include "sigmasweep/model/relevance.hpp"

#include "model/fields/conditions.hpp"

namespace sigmasweep {

bool has_given_steps(const Parameters& tuple) { return conditions::given_steps.holds(tuple); }

}  // namespace sigmasweep
