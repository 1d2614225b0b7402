#include "sweep/reference/parameter.hpp"

#include <fmt/format.h>

#include "sigmasweep/model/relevance.hpp"
#include "sweep/spec/tuples/base.hpp"

namespace sigmasweep {
std::string parameter_line(const ParameterField& field) {
  std::string line(field.meaning);
  if (field.unit != "1") line += fmt::format(", {}", field.unit);
  if (!field.allowed.must_be.empty()) line += fmt::format("; {}", field.allowed.must_be);
  if (spec::has_default(field)) line += fmt::format("; default: {}", text(field, Parameters{}));
  if (const std::string needs = requirement_of(field); !needs.empty()) line += fmt::format("; only with {}", needs);
  return line;
}

}  // namespace sigmasweep
