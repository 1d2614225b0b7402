#pragma once

#include <memory>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// A condition on an Owner, a row or its parameters: an expression over the fields' names and the enumerators' names,
/// such as `sigma > 1e-4 && (method == md || N <= 10)`. Operators || && ! == != < <= > >= + - * / ^ ?: and muParser's
/// functions (abs, sqrt, exp, ln, log10, min, max, ...). Types are checked: it must be boolean as a whole, numbers are
/// no truth values, and an enumeration compares only with its own names. Right after a field that is an enumeration and
/// == or != a name is one of its values, whatever else is called so (`ed_rule == tc && tc > 1e-5`, `material == none`)
/// and whatever it is made of (`law == hertz-kuwabara-kono`, `random_separation == true`).
template <class Owner>
class WhereOf {
 public:
  static constexpr std::size_t max_length = 1024;

  /// Throws UsageError saying what is wrong with the expression and, for an unknown name, the nearest known one.
  WhereOf(const std::string& expression, std::span<const FieldOf<Owner>> fields);
  ~WhereOf();
  WhereOf(WhereOf&&) noexcept;
  WhereOf& operator=(WhereOf&&) noexcept;

  /// Not for use by several threads at once.
  bool operator()(const Owner& owner);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

using Where = WhereOf<Row>;
using ParameterWhere = WhereOf<Parameters>;

extern template class WhereOf<Row>;
extern template class WhereOf<Parameters>;

}  // namespace sigmasweep
