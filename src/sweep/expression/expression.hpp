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

/// An expression over the fields of an Owner, such as a row, and the names of enumerators. Where and Formula use it.
template <class Owner>
class Expression {
 public:
  static constexpr std::size_t max_length = 1024;

  /// Throws UsageError with the mistake in the expression and, for an unknown name, the nearest known one.
  Expression(const std::string& text, std::span<const FieldOf<Owner>> fields, expression_types::Wanted wanted);
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// Must not be called by several threads at once.
  double operator()(const Owner& owner);
  /// The fields in the expression, in the order of their first use.
  std::vector<FieldOf<Owner>> used() const;

 private:
  struct Variable {
    const FieldOf<Owner>* field;  ///< null for an enumerator
    FieldType type;
    double value;
  };
  void define(std::string_view name, const Variable& variable);
  void define_enumerators();
  std::string stand_in(const FieldType& enumeration, std::size_t number) const;
  std::string resolved(const std::string& text) const;
  FieldType use(const double* value);
  std::string explain(const mu::ParserError& error) const;

  std::vector<FieldOf<Owner>> fields_;
  std::vector<FieldType> enumerations_;  ///< types of the fields that are enumerations, each once
  mu::Parser parser_;
  std::deque<Variable> variables_;  ///< the parser and its byte code keep pointers to the values
  std::vector<Variable*> used_;     ///< variables of the fields in the expression
  std::vector<std::string_view> names_;
};

extern template class Expression<Row>;
extern template class Expression<Parameters>;
extern template class Expression<double>;

}  // namespace sigmasweep
