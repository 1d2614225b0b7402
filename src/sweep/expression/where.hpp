#pragma once

#include <memory>
#include <span>
#include <string>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// A condition on rows: an expression over the fields' names and the enumerators' names, such as
/// `sigma > 1e-4 && (method == md || N <= 10)`. Operators || && ! == != < <= > >= + - * / ^ ?: and muParser's
/// functions (abs, sqrt, exp, ln, log10, min, max, ...). Types are checked: it must be boolean as a whole, numbers are
/// no truth values, and an enumeration compares only with its own names. Right after a field that is an enumeration and
/// == or != a name is one of its values, whatever else is called so (`ed_rule == tc && tc > 1e-5`, `material == none`)
/// and whatever it is made of (`law == hertz-kuwabara-kono`, `random_separation == true`).
class Where {
 public:
  static constexpr std::size_t max_length = 1024;

  /// Throws UsageError saying what is wrong with the expression and, for an unknown name, the nearest known one.
  Where(const std::string& expression, std::span<const Field> fields);
  ~Where();
  Where(Where&&) noexcept;
  Where& operator=(Where&&) noexcept;

  /// Not for use by several threads at once.
  bool operator()(const Row& row);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sigmasweep
