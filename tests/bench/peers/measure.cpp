#include "bench/peers/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/thread_clock.hpp"

namespace sigmasweep::peers {
namespace {

/// One method and the tuples of one group.
struct Cell {
  nlohmann::json names;
  std::vector<Tuple> tuples;
  Run run;
  std::vector<double> found;
  double seconds = std::numeric_limits<double>::infinity();

  Cell(nlohmann::json its_names, const Method& method, std::vector<Tuple> its_tuples)
      : names(std::move(its_names)), tuples(std::move(its_tuples)), run(method.prepare(tuples)), found(tuples.size()) {
    names["method"] = method.name;
    names["setting"] = method.setting;
  }
  void measure() {
    const double start = thread_seconds();
    run(found);
    seconds = std::min(seconds, (thread_seconds() - start) / static_cast<double>(tuples.size()));
  }
};

nlohmann::json outcome(const Cell& cell) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < cell.tuples.size(); ++i)
    if (std::isfinite(cell.found[i])) errors.push_back(std::abs(cell.found[i] - cell.tuples[i].eps_eff));
  std::ranges::sort(errors);
  nlohmann::json all = cell.names;
  all["seconds"] = cell.seconds;
  all["failed"] = cell.tuples.size() - errors.size();
  all["error_max"] = errors.empty() ? nlohmann::json() : nlohmann::json(errors.back());
  all["error_median"] = errors.empty() ? nlohmann::json() : nlohmann::json(errors[errors.size() / 2]);
  return all;
}

std::vector<Tuple> like_beside_each_other(std::span<const Group> groups) {
  std::vector<Tuple> all;
  for (const Group& group : groups) all.insert(all.end(), group.tuples.begin(), group.tuples.end());
  return all;
}

std::vector<Tuple> interleaved(std::span<const Group> groups) {
  std::vector<Tuple> all;
  for (std::size_t k = 0; k < groups.front().tuples.size(); ++k)
    for (const Group& group : groups) all.push_back(group.tuples[k]);
  return all;
}

std::vector<Cell> cells_of(std::span<const Method> methods, std::span<const Group> groups) {
  std::vector<Cell> cells;
  for (const Group& group : groups)
    for (const Method& method : methods)
      cells.emplace_back(nlohmann::json{{"sigma", group.sigma}}, method, group.tuples);
  for (const Method& method : methods)
    if (method.side_by_side) {
      cells.emplace_back(nlohmann::json{{"order", "like"}}, method, like_beside_each_other(groups));
      cells.emplace_back(nlohmann::json{{"order", "interleaved"}}, method, interleaved(groups));
    }
  return cells;
}

}  // namespace

nlohmann::json measure(std::span<const Method> methods, std::span<const Group> groups, int rounds) {
  std::vector<Cell> cells = cells_of(methods, groups);
  for (int round = 0; round < rounds; ++round)
    for (Cell& cell : cells) cell.measure();
  nlohmann::json all = nlohmann::json::array();
  for (const Cell& cell : cells) all.push_back(outcome(cell));
  return all;
}

}  // namespace sigmasweep::peers
