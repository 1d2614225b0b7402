#include "sweep/expression/formula.hpp"

#include "sweep/expression/expression.hpp"

namespace sigmasweep {

struct Formula::Impl {
  Expression<Row> expression;
};

Formula::Formula(const std::string& expression, std::span<const Field> fields)
    : impl_(new Impl{{expression, fields, expression_types::Wanted::number}}) {}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

double Formula::operator()(const Row& row) { return impl_->expression(row); }
std::vector<Field> Formula::used() const { return impl_->expression.used(); }

namespace {

/// The variable of a function: a number is its own field.
constexpr FieldOf<double> variable{.name = "x", .type = FieldType::real, .offset = 0, .unit = "1"};

}  // namespace

FunctionOfX::FunctionOfX(const std::string& expression)
    : expression_(std::make_unique<Expression<double>>(expression, std::span(&variable, 1),
                                                       expression_types::Wanted::number)) {}

FunctionOfX::~FunctionOfX() = default;
FunctionOfX::FunctionOfX(FunctionOfX&&) noexcept = default;
FunctionOfX& FunctionOfX::operator=(FunctionOfX&&) noexcept = default;

double FunctionOfX::operator()(double x) { return (*expression_)(x); }

}  // namespace sigmasweep
