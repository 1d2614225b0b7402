#pragma once

#include <string>

#include "sigmasweep/model/fields.hpp"

/// Relevance of fields for a tuple, from the conditions in the registry.
namespace sigmasweep {

/// Whether the tuple uses this parameter as a given one. It does not use a parameter that its solver ignores, or that
/// follows from others (tc and epsilon from K_over_m, these from the material). For a result: whether the tuple has it.
template <class Owner>
bool applies_to(const FieldOf<Owner>& field, const Parameters& tuple) {
  for (const Condition* condition : field.applies)
    if (condition && !condition->holds(tuple)) return false;
  return true;
}

/// The condition on tuples that use the field, for messages: "method = 'md'"; empty if every tuple uses it.
template <class Owner>
std::string requirement_of(const FieldOf<Owner>& field) {
  std::string needs;
  for (const Condition* condition : field.applies)
    if (condition) needs.append(needs.empty() ? "" : ", and ").append(condition->needs);
  return needs;
}

/// Whether the tuple is computed in steps of a fixed length that steps_per_tc gives.
bool has_given_steps(const Parameters& tuple);

}  // namespace sigmasweep
