#pragma once

#include <memory>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// A condition on an Owner, which is a row or its parameters: an expression over names of fields and of enumerators,
/// such as `sigma > 1e-4 && (method == md || N <= 10)`. Operators are || && ! == != < <= > >= + - * / ^ ?:, functions
/// are those of muParser (abs, sqrt, exp, ln, log10, min, max, ...). The expression must be boolean as a whole. A
/// number is not a truth value, and an enumeration compares only with its own names. After an enumeration and == or !=,
/// a name is that of an enumerator, even if a field has the same name (`ed_rule == tc && tc > 1e-5`), several
/// enumerations have it (`material == none`), or it is not a word (`law == hertz-kuwabara-kono`).
template <class Owner>
class WhereOf {
 public:
  static constexpr std::size_t max_length = 1024;

  /// Throws UsageError with the mistake in the expression and, for an unknown name, the nearest known one.
  WhereOf(const std::string& expression, std::span<const FieldOf<Owner>> fields);
  ~WhereOf();
  WhereOf(WhereOf&&) noexcept;
  WhereOf& operator=(WhereOf&&) noexcept;

  /// Must not be called by several threads at once.
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
