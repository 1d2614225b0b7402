#include "engine/report/summary_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/exit_codes.hpp"

namespace sigmasweep {
namespace {

using Json = nlohmann::ordered_json;

Json quantiles_json(const std::vector<Quantiles>& quantiles) {
  Json all = Json::object();
  for (const auto& [name, values] : quantiles)
    all[name] = {{"median", values[0]}, {"90%", values[1]}, {"99%", values[2]}, {"max", values[3]}};
  return all;
}

Json work_json(const RunEnd& end) {
  return {{"rows", end.work.rows},
          {"ranks", end.ranks},
          {"wall_seconds", end.wall_seconds},
          {"cpu_seconds", end.work.cpu_seconds},
          {"longest_seconds", end.work.longest_seconds},
          {"computing_seconds", end.work.computing_seconds},
          {"best_possible_seconds", least_seconds(end.work, end.ranks)}};
}

Json statuses_json(const Overview& seen) {
  Json counts = Json::object();
  for (const auto& [name, count] : seen.by_status) counts[std::string(name)] = count;
  return counts;
}

Json universality_json(const Universality& found) {
  if (found.groups == 0) return nullptr;
  return {{"spread", found.spread}, {"sigma", found.sigma}, {"groups", found.groups}};
}

}  // namespace

std::string summary_json(const RowSource& rows, const Overview& seen, const RunEnd& end) {
  const Json document = {{"table", end.table},
                         {"state", end.exit_code == exit_code::stopped ? "stopped" : "complete"},
                         {"exit_code", end.exit_code},
                         {"rows", end.total},
                         {"done", rows.size()},
                         {"by_status", statuses_json(seen)},
                         {"computed", work_json(end)},
                         {"quantiles", quantiles_json(seen.quantiles)},
                         {"universality", universality_json(universality(rows))}};
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sigmasweep
