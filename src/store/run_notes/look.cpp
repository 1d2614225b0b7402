#include "store/run_notes/look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "store/run_notes/contents.hpp"

namespace sigmasweep {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto look_every = std::chrono::milliseconds(100);

struct Verdict {
  bool is_running = false;
  std::string reason;
};

/// What the processes of this machine tell; nothing if the run has others, and none of this machine exists.
std::optional<Verdict> ask_processes(const notes::Contents& found, const Machine& here) {
  bool some_here = false, all_here = true;
  for (const notes::RankPage& page : found.ranks) {
    if (page.process.number == 0) continue;  // it has not begun
    const bool is_here = here.is_known() && page.machine == here;
    some_here = some_here || is_here;
    all_here = all_here && is_here;
    if (is_here && exists(page.process))
      return Verdict{true, fmt::format("process {} of this machine exists", page.process.number)};
  }
  if (some_here && all_here) return Verdict{false, "its processes, which were on this machine, do not exist"};
  return std::nullopt;
}

/// The rank one of whose heartbeats came between two looks.
std::optional<std::size_t> has_beaten(const notes::Contents& before, const notes::Contents& now) {
  for (std::size_t rank = 0; rank < now.ranks.size() && rank < before.ranks.size(); ++rank)
    if (before.ranks[rank].beat != now.ranks[rank].beat) return rank;
  return std::nullopt;
}

/// Waits for a heartbeat. `found` is then what was read last.
Verdict wait_for_heartbeat(const std::string& path, notes::Contents& found, std::chrono::milliseconds patience) {
  const notes::Contents first = found;
  const auto end = Clock::now() + patience;
  while (Clock::now() < end) {
    std::this_thread::sleep_for(look_every);
    auto now = notes::read(path);
    if (!now || now->ranks.empty()) return {false, "its notes were removed"};
    found = *std::move(now);
    if (found.header.run != first.header.run) return {true, "another run has begun"};
    if (const auto rank = has_beaten(first, found))
      return {true, fmt::format("rank {} on {} sent a heartbeat", *rank, found.ranks[*rank].host.data())};
  }
  return {false, fmt::format("no rank sent a heartbeat for {} s", double(patience.count()) * 1e-3)};
}

double seconds_between(std::int64_t begin, std::int64_t end) {
  return std::max(0.0, static_cast<double>(end - begin) * 1e-9);
}

RankState state_of(int rank, const notes::RankPage& page, bool is_running, const Machine& here, double period) {
  RankState state{.rank = rank, .host = page.host.data()};
  // The clock of this machine counts for its own processes only; the last heartbeat counts for all.
  const bool same_clock = is_running && here.is_known() && page.machine.boot == here.boot;
  const std::int64_t now = same_clock ? monotonic_nanoseconds() : page.beat;
  if (page.row_plus_1 > 0) {
    state.row = page.row_plus_1 - 1;
    state.seconds = seconds_between(page.began, now);
  }
  if (const double silent = seconds_between(page.beat, now); silent > 5.0 * period) state.silent = silent;
  return state;
}

}  // namespace

std::optional<RunState> look_at_run(const std::string& table, std::chrono::milliseconds patience) {
  const std::string path = notes::path_of(table);
  auto found = notes::read(path);
  if (!found || found->ranks.empty()) return std::nullopt;
  const Machine here = this_machine();
  std::optional<Verdict> verdict = ask_processes(*found, here);
  if (!verdict) verdict = wait_for_heartbeat(path, *found, patience);
  RunState state{verdict->is_running, std::move(verdict->reason), found->header.spec_hash};
  state.progress = {found->header.done, found->header.seconds, found->header.seconds_left};
  for (std::size_t rank = 0; rank < found->ranks.size(); ++rank)
    state.ranks.push_back(state_of(static_cast<int>(rank), found->ranks[rank], state.is_running, here,
                                   heartbeat_period(found->ranks.size())));
  return state;
}

}  // namespace sigmasweep
