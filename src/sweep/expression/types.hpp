#pragma once

#include <functional>

#include <muParserBytecode.h>

#include "sigmasweep/model/fields.hpp"

/// muParser knows only numbers. The types of an expression are checked on its byte code, which is the expression in
/// reverse Polish notation.
namespace sigmasweep::expression_types {

double logical_not(double value);

/// What an expression must be as a whole.
enum class Wanted { truth, number };

/// Throws UsageError unless the expression is what is wanted, with each operator on operands that suit it.
void require(Wanted wanted, const mu::ParserByteCode& code,
             const std::function<FieldType(const double*)>& type_of_variable);

}  // namespace sigmasweep::expression_types
