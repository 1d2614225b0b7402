#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <muParser.h>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"
#include "sweep/expression/types.hpp"

namespace sigmasweep {

/// An expression over the fields of a row and the names of enumerators: what Where and Formula have in common.
class Expression {
 public:
  static constexpr std::size_t max_length = 1024;

  /// Throws UsageError saying what is wrong with the expression and, for an unknown name, the nearest known one.
  Expression(const std::string& text, std::span<const Field> fields, expression_types::Wanted wanted);
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// Not for use by several threads at once.
  double operator()(const Row& row);
  /// The fields that it needs, in the order of their first use.
  std::vector<Field> used() const;

 private:
  struct Variable {
    const Field* field;  ///< null for an enumerator
    FieldType type;
    double value;
  };
  void define(std::string_view name, const Variable& variable);
  void define_enumerators();
  std::string resolved(const std::string& text) const;
  FieldType use(const double* value);
  std::string explain(const mu::ParserError& error) const;

  std::vector<Field> fields_;
  mu::Parser parser_;
  std::deque<Variable> variables_;  ///< the parser and its byte code keep pointers to the values
  std::vector<Variable*> used_;     ///< fields that the expression needs
  std::vector<std::string_view> names_;
};

}  // namespace sigmasweep
