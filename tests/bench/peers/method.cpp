#include "bench/peers/method.hpp"

#include <utility>
#include <vector>

namespace sigmasweep::peers {

Method one_by_one(std::string name, std::string setting, std::function<double(const Tuple&)> eps_eff) {
  const auto prepare = [eps_eff = std::move(eps_eff)](std::span<const Tuple> given) -> Run {
    return [eps_eff, tuples = std::vector(given.begin(), given.end())](std::span<double> found) {
      for (std::size_t i = 0; i < tuples.size(); ++i) found[i] = eps_eff(tuples[i]);
    };
  };
  return {.name = std::move(name), .setting = std::move(setting), .prepare = prepare};
}

}  // namespace sigmasweep::peers
