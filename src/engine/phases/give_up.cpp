#include "engine/phases/give_up.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "base/file.hpp"
#include "base/output/place.hpp"
#include "engine/stop/last_resort.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/run_notes/look.hpp"

namespace sigmasweep {
namespace {

std::string in_words(int rank, const std::string& host, std::optional<std::uint64_t> row) {
  return fmt::format("rank {}{}{}", rank, host.empty() ? "" : " on " + host, row ? fmt::format(" (row {})", *row) : "");
}

std::optional<RunState> state_of(const std::string& table) noexcept {
  try {
    return look_at_run(table, std::chrono::seconds(2));
  } catch (...) {
    return std::nullopt;
  }
}

}  // namespace

void give_up(const std::vector<SilentRank>& silent, OpenSweep& open, const Reporter& reporter) {
  try {
    open.ledger->journal().sync();
  } catch (const Error& error) {
    reporter.warn(error.what());
  }
  const std::optional<RunState> state = state_of(open.table);
  for (const auto& [rank, task] : silent) {
    const auto place = static_cast<std::size_t>(rank);
    const std::string host = state && place < state->ranks.size() ? state->ranks[place].host : "";
    reporter.warn(fmt::format("{} does not answer any more and is given up", in_words(rank, host, task)));
  }
  reporter.warn(fmt::format("stopped with {} of {} rows done; {} to go on", open.ledger->there(), open.rows(),
                            open.restart_hint()));
  end_run_notes(open.table, open.ledger->is_complete());
  LastResort::end_all_ranks();
}

std::string give_up_without_manager(const std::string& table) {
  if (const File journal(beside(table, ".journal"), O_RDWR | O_NOFOLLOW); journal.is_open()) ::fdatasync(journal.fd());
  std::string words;
  if (const auto state = state_of(table)) {
    for (const RankState& rank : state->ranks)
      if (rank.silent)
        words += fmt::format("{}{}", words.empty() ? "" : "; ", in_words(rank.rank, rank.host, rank.row));
    end_run_notes(table, false);
  }
  return words.empty() ? "other ranks do not answer" : words + " does not answer";
}

bool is_some_rank_silent(const std::string& table) {
  const auto state = state_of(table);
  return state && std::ranges::any_of(state->ranks, [](const RankState& rank) { return rank.silent.has_value(); });
}

}  // namespace sigmasweep
