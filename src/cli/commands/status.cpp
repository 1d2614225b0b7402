#include "store/status.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/duration.hpp"
#include "base/printable.hpp"
#include "cli/command.hpp"
#include "store/rows/json.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {
namespace {

struct StatusOptions {
  std::string table;
  bool json = false;
};

using Json = nlohmann::ordered_json;

template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

void print_json(const std::string& table, const SweepStatus& status) {
  Json document = {{"table", table},
                   {"state", status.state()},
                   {"rows", status.stored.total},
                   {"done", status.stored.table.rows.size()},
                   {"by_status", counts_by_status(status.stored.table.rows)},
                   {"rows_per_second", json_or_null(status.rows_per_second())},
                   {"seconds_left", json_or_null(status.seconds_left())},
                   {"ranks", Json::array()}};
  if (status.run)
    for (const RankState& rank : status.run->ranks)
      document["ranks"].push_back({{"rank", rank.rank},
                                   {"host", rank.host},
                                   {"row", json_or_null(rank.row)},
                                   {"seconds", json_or_null(rank.seconds)}});
  fmt::print("{}\n", document.dump(1, ' ', false, Json::error_handler_t::replace));
}

void print_ranks(const RunState& run) {
  fmt::print("\n{:>6}  {:<24} {:>12}  {}\n", "rank", "host", "row", run.is_running ? "for" : "for, when the run died");
  for (const RankState& rank : run.ranks) {
    const std::string row = rank.row ? fmt::format("{}", *rank.row) : "-";
    const std::string silent =
        rank.silent ? fmt::format("  no heartbeat for {}", readable_duration(*rank.silent)) : std::string();
    fmt::print("{:>6}  {:<24} {:>12}  {}{}\n", rank.rank, printable(rank.host), row,
               rank.seconds ? readable_duration(*rank.seconds) : "-", silent);
  }
}

void print_text(const std::string& table, const SweepStatus& status) {
  const auto& [info, columns, rows] = status.stored.table;
  if (!info.title.empty()) fmt::print("{}\n", printable(info.title));
  const std::string known = status.run ? fmt::format(" ({})", printable(status.run->known_by)) : std::string();
  const std::string counts = rows.empty() ? std::string() : fmt::format(" ({})", rows_by_status(rows));
  fmt::print("{}: {}{}\n", table, status.state(), known);
  fmt::print("{} of {} rows{}\n", rows.size(), status.stored.total, counts);
  if (const auto rate = status.rows_per_second()) fmt::print("{:.3g} rows/s\n", *rate);
  if (const auto left = status.seconds_left(); left && !status.stored.complete)
    fmt::print("{} left\n", readable_duration(*left));
  if (status.run) print_ranks(*status.run);
}

int print_status(const StatusOptions& options) {
  const SweepStatus status = status_of_sweep(options.table);
  if (options.json)
    print_json(options.table, status);
  else
    print_text(options.table, status);
  return 0;
}

void declare(OptionSet& set, StatusOptions& options) {
  set.add({"table", "A table that 'run' wrote, or will write", "TABLE.h5"}, options.table);
  set.add_flag("--json", "One JSON document; times in seconds", options.json);
}

}  // namespace

Command status_command() {
  return make_command(
      "status", "Look at a sweep that runs, was stopped or killed, or is finished",
      "\nRows done by status, rows a second and time left of this run, and which row each rank computes and for how\n"
      "long. Reads the journal and the run's notes beside the table, changes nothing, and may be called on any "
      "machine\n"
      "that shares the file system. A sweep is running if a process of its run exists on this machine, or if a rank "
      "on\n"
      "another one sends a heartbeat within 5 s.\n\n"
      "  sigmasweep status fig2a.h5",
      declare, print_status);
}

}  // namespace sigmasweep
