#include "sweep/dependents.hpp"

#include <algorithm>
#include <cmath>

#include "sigmasweep/model/exact_number.hpp"
#include "sweep/expression/expression.hpp"

namespace sigmasweep {

Dependents::Dependents() : evaluating_(std::make_unique<std::mutex>()) {}
Dependents::~Dependents() = default;
Dependents::Dependents(Dependents&&) noexcept = default;
Dependents& Dependents::operator=(Dependents&&) noexcept = default;

void Dependents::add(const ParameterField& field, const std::string& expression) {
  all_.push_back({&field, std::make_unique<Expression<Parameters>>(expression, fields_of_parameters(),
                                                                   expression_types::Wanted::number)});
}

void Dependents::set(Parameters& parameters) const {
  if (all_.empty()) return;
  const std::lock_guard alone(*evaluating_);
  for (const One& one : all_) {
    const double value = (*one.expression)(parameters);
    set_exact_number(*one.field, parameters, one.field->type == FieldType::integer ? std::round(value) : value);
  }
}

std::vector<std::string_view> Dependents::with_causes(std::span<const std::string_view> names) const {
  std::vector<std::string_view> all(names.begin(), names.end());
  for (auto one = all_.rbegin(); one != all_.rend(); ++one)
    if (std::ranges::find(all, one->field->name) != all.end())
      for (const ParameterField& cause : one->expression->used()) all.push_back(cause.name);
  return all;
}

}  // namespace sigmasweep
