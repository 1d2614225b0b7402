#pragma once

#include <string>

#include "sigmasweep/model/fields.hpp"

/// Which parameters count for a tuple: the one list of rules for what a spec may give and what repeats a row.
namespace sigmasweep {

/// Whether the tuple depends on this parameter as a given one: not if its solver does not look at it, nor if it follows
/// from others (tc and epsilon from K_over_m, these from the material). Of a result: whether the tuple has it.
bool applies_to(const Field& parameter, const Parameters& tuple);

/// What a tuple must have to use it, for messages: "method = 'md'"; empty if every one does.
std::string requirement_of(const Field& parameter);

/// Whether the tuple is computed in steps of a fixed length that steps_per_tc gives.
bool has_given_steps(const Parameters& tuple);

}  // namespace sigmasweep
