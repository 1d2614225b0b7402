#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/parameters.hpp"

namespace sigmasweep {

template <class Owner>
class Expression;

/// Parameters that are expressions of other parameters, such as s0 = "0.01*d".
class Dependents {
 public:
  Dependents();
  ~Dependents();
  Dependents(Dependents&&) noexcept;
  Dependents& operator=(Dependents&&) noexcept;

  /// Adds a parameter, which may use those before it. Throws UsageError for a mistake in the expression.
  void add(const ParameterField& field, const std::string& expression);
  /// Sets the parameters from the others. Whole numbers are rounded. Several threads may call it at once.
  void set(Parameters& parameters) const;
  /// These parameters, and all on which they depend.
  std::vector<std::string_view> with_causes(std::span<const std::string_view> names) const;

 private:
  struct One {
    const ParameterField* field;
    std::unique_ptr<Expression<Parameters>> expression;
  };
  std::vector<One> all_;
  std::unique_ptr<std::mutex> evaluating_;  ///< expressions keep their variables
};

}  // namespace sigmasweep
