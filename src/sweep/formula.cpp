#include "sigmasweep/sweep/formula.hpp"

#include "expression.hpp"

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

}  // namespace sigmasweep
