#include "solve/fixed_step/scheme_info.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "solve/fixed_step/schemes/scheme_list.hpp"

namespace sigmasweep {
namespace {

template <class... Schemes>
constexpr auto table_of(SchemeList<Schemes...> /*all*/) {
  return std::array{SchemeInfo{Schemes::id, Schemes::evaluations, Schemes::cost, &Schemes::step_map}...};
}
constexpr auto table = table_of(FixedStepSchemes{});

}  // namespace

std::span<const SchemeInfo> schemes() { return table; }

const SchemeInfo& scheme_info(Integrator integrator) {
  const auto found = std::ranges::find(table, integrator, &SchemeInfo::id);
  if (found == table.end()) throw std::invalid_argument("scheme_info: not an integrator of fixed step");
  return *found;
}

}  // namespace sigmasweep
