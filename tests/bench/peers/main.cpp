// peers [--tuples V] [--rounds R] [--methods REGEX]: computes the reference set by every method that is built in, and
// prints errors and times as one JSON document. `tests/bench/peers/run` calls it; docs/peers.md explains it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <regex>

#include "bench/peers/cvode_events.hpp"
#include "bench/peers/measure.hpp"
#include "bench/peers/odeint_events.hpp"
#include "bench/peers/odeint_plain.hpp"
#include "bench/peers/own_methods.hpp"
#include "bench/peers/tuples.hpp"

namespace {

using namespace sigmasweep::peers;

std::vector<Method> all_methods(const std::string& wanted) {
  std::vector<Method> methods;
  const std::regex expression(wanted);
  for (const auto& some : {own_methods(), odeint_event_methods(), odeint_plain_methods(), cvode_methods()})
    for (const Method& method : some)
      if (std::regex_search(method.name, expression)) methods.push_back(method);
  return methods;
}

/// The tuples for programs of their own: what they start from, how long they have to go on, what is right.
nlohmann::json tuples_of(const std::vector<Group>& groups) {
  nlohmann::json all = nlohmann::json::array();
  for (const Group& group : groups)
    for (const Tuple& tuple : group.tuples)
      all.push_back({{"sigma", group.sigma},
                     {"gap", tuple.sigma()},
                     {"phase", tuple.phase},
                     {"duration", odeint_with_events(tuple.sigma(), 1e-6).duration},
                     {"eps_eff", tuple.eps_eff}});
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t tuples = 32;
  int rounds = 5;
  std::string wanted = ".";
  CLI::App app{"Error against time of the reference set, by this program and by its peers, as JSON."};
  app.add_option("--tuples", tuples, "tuples for each sigma")->check(CLI::Range(1, 1000));
  app.add_option("--rounds", rounds, "how often each method computes each tuple; 0: the tuples only");
  app.add_option("--methods", wanted, "regular expression that the names of methods must match");
  CLI11_PARSE(app, argc, argv);
  const std::vector<Group> groups = reference_set(tuples);
  const nlohmann::json all = {
      {"tuples", tuples_of(groups)},
      {"cells", rounds > 0 ? measure(all_methods(wanted), groups, rounds) : nlohmann::json::array()}};
  fmt::print("{}\n", all.dump(1));
}
