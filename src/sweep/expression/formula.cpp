#include "sweep/expression/formula.hpp"

#include <cstddef>

#include "sweep/expression/expression.hpp"

namespace sigmasweep {

struct Formula::Impl {
  Expression expression;
};

Formula::Formula(const std::string& expression, std::span<const Field> fields)
    : impl_(new Impl{{expression, fields, expression_types::Wanted::number}}) {}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

double Formula::operator()(const Row& row) { return impl_->expression(row); }
std::vector<Field> Formula::used() const { return impl_->expression.used(); }

namespace {

/// Some number of a row, under the name of x.
constexpr Field x_of_row{"x", "1", "the variable", FieldType::real, offsetof(Row, parameters.v0)};

}  // namespace

FunctionOfX::FunctionOfX(const std::string& expression) : formula_(expression, std::span(&x_of_row, 1)) {}

double FunctionOfX::operator()(double x) {
  Row row;
  set_number(x_of_row, row, x);
  return formula_(row);
}

}  // namespace sigmasweep
