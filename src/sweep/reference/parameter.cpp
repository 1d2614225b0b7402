#include "sweep/reference/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "sigmasweep/model/relevance.hpp"

namespace sigmasweep {
namespace {

/// Parameters that have to be given, or that stand for each other (spec/check.cpp): their defaults are of no use.
constexpr auto without_default = std::to_array<std::string_view>(
    {"v0", "tc", "s0", "sigma", "N", "epsilon", "K_over_m", "beta", "gamma", "rows", "alpha", "A0"});

}  // namespace

std::string parameter_line(const ParameterField& field) {
  std::string line(field.meaning);
  if (field.unit != "1") line += fmt::format(", {}", field.unit);
  if (!field.allowed.must_be.empty()) line += fmt::format("; {}", field.allowed.must_be);
  if (std::ranges::find(without_default, field.name) == without_default.end())
    line += fmt::format("; default: {}", text(field, Parameters{}));
  if (const std::string needs = requirement_of(field); !needs.empty()) line += fmt::format("; only with {}", needs);
  return line;
}

}  // namespace sigmasweep
