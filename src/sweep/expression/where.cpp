#include "sweep/expression/where.hpp"

#include "sweep/expression/expression.hpp"

namespace sigmasweep {

template <class Owner>
struct WhereOf<Owner>::Impl {
  static_assert(max_length == Expression<Owner>::max_length);
  Expression<Owner> expression;
};

template <class Owner>
WhereOf<Owner>::WhereOf(const std::string& expression, std::span<const FieldOf<Owner>> fields)
    : impl_(new Impl{{expression, fields, expression_types::Wanted::truth}}) {}

template <class Owner>
WhereOf<Owner>::~WhereOf() = default;
template <class Owner>
WhereOf<Owner>::WhereOf(WhereOf&&) noexcept = default;
template <class Owner>
WhereOf<Owner>& WhereOf<Owner>::operator=(WhereOf&&) noexcept = default;

template <class Owner>
bool WhereOf<Owner>::operator()(const Owner& owner) {
  return impl_->expression(owner) != 0.0;
}

template class WhereOf<Row>;
template class WhereOf<Parameters>;

}  // namespace sigmasweep
