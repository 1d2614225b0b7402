#include "sweep/spec/run.hpp"

#include <array>

namespace sigmasweep::spec {
namespace {

constexpr std::array<std::string_view, 3> managers{"auto", "computes", "dedicated"};

constexpr auto keys = std::to_array<Key<RunSpec>>({
    {{"manager", KeyForm::choice, "whether the manager rank also computes", "auto", managers},
     [](const Entry& entry, RunSpec& run) { run.manager = static_cast<ManagerRole>(as_one_of(entry, managers)); }},
    {{"tuple_time_limit", KeyForm::number, "CPU time after which a tuple is given up, s",
      "100 times the predicted time, at least 60"},
     [](const Entry& entry, RunSpec& run) {
       run.tuple_time_limit = as_number(entry);
       if (!(*run.tuple_time_limit > 0.0)) refuse_value(entry, "must be a time > 0, in s");
     }},
});

}  // namespace

RunSpec read_run(const Entry& table) {
  RunSpec run;
  read_keys(table, keys, run);
  return run;
}

std::vector<KeyInfo> keys_of_run() { return infos_of(keys); }

}  // namespace sigmasweep::spec
