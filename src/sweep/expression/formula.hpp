#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

template <class Owner>
class Expression;

/// A number that is computed from the fields of a row, such as `(1 - eps_eff)/(1 - epsilon)`, with the operators and
/// functions of Where.
class Formula {
 public:
  /// Throws UsageError as Where does.
  Formula(const std::string& expression, std::span<const Field> fields);
  ~Formula();
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;

  /// Must not be called by several threads at once.
  double operator()(const Row& row);
  /// The fields in the formula, in the order of their first use.
  std::vector<Field> used() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A function of x, such as "0.5*x^2 + sin(x)", with the operators and functions of Where.
class FunctionOfX {
 public:
  /// Throws UsageError as Formula does.
  explicit FunctionOfX(const std::string& expression);
  ~FunctionOfX();
  FunctionOfX(FunctionOfX&&) noexcept;
  FunctionOfX& operator=(FunctionOfX&&) noexcept;
  double operator()(double x);

 private:
  std::unique_ptr<Expression<double>> expression_;
};

}  // namespace sigmasweep
