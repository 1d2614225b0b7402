#pragma once

#include <functional>

#include <muParserBytecode.h>

#include "sigmasweep/model/fields.hpp"

/// Types of expressions. muParser has numbers only, so types are checked on its byte code, which is the expression in
/// reverse Polish notation.
namespace sigmasweep::expression_types {

double logical_not(double value);

/// The type that an expression must have as a whole.
enum class Wanted { truth, number };

/// Throws UsageError unless the expression has the wanted type, and each operator has operands of its types.
void require(Wanted wanted, const mu::ParserByteCode& code,
             const std::function<FieldType(const double*)>& type_of_variable);

}  // namespace sigmasweep::expression_types
