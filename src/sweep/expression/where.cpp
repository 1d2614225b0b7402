#include "sweep/expression/where.hpp"

#include "sweep/expression/expression.hpp"

namespace sigmasweep {

static_assert(Where::max_length == Expression::max_length);

struct Where::Impl {
  Expression expression;
};

Where::Where(const std::string& expression, std::span<const Field> fields)
    : impl_(new Impl{{expression, fields, expression_types::Wanted::truth}}) {}

Where::~Where() = default;
Where::Where(Where&&) noexcept = default;
Where& Where::operator=(Where&&) noexcept = default;

bool Where::operator()(const Row& row) { return impl_->expression(row) != 0.0; }

}  // namespace sigmasweep
