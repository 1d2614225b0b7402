#include "engine/phases/note_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "engine/phases/phase.hpp"
#include "mpi/run_collective.hpp"

namespace sigmasweep {
namespace {

/// Leaves out rows during which processes died. On the manager.
void quarantine(OpenSweep& open, const SuspicionByRow& suspicion, const Reporter& reporter) {
  constexpr std::uint64_t too_much = 4;  // two runs that died while they computed this row alone
  for (const auto& [row, score] : suspicion) {
    if (score < too_much || open.ledger->has(row)) continue;
    open.ledger->quarantine({row, open.sweep.at(row)});
    reporter.say(fmt::format("row {} is left out, processes died while they computed it (--retry tries again)", row));
  }
}

/// The manager's set on every rank. Collective.
std::set<std::uint64_t> broadcast(const World& world, const std::set<std::uint64_t>& set) {
  const std::vector<std::uint64_t> numbers(set.begin(), set.end());
  const std::string bytes =
      world.broadcast(std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof numbers[0]));
  std::vector<std::uint64_t> received(bytes.size() / sizeof numbers[0]);
  std::ranges::copy(std::as_bytes(std::span(bytes)), std::as_writable_bytes(std::span(received)).begin());
  return {received.begin(), received.end()};
}

}  // namespace

NotedRun::NotedRun(const World& world, OpenSweep& open, const Reporter& reporter)
    : open_(open), is_manager_(world.is_manager()) {
  RunNotesIdentity identity{open.sweep.hash(), open.sweep.size(), std::random_device{}()};
  identity.run = static_cast<std::uint64_t>(world.broadcast(static_cast<std::int64_t>(identity.run)));
  on_manager(world, [&] {
    const auto suspicion = begin_run_notes(open.table, identity, world.size(), open.fresh || open.retry);
    quarantine(open, suspicion, reporter);
    for (const auto& [row, score] : suspicion)
      if (!open.ledger->has(row)) suspects_.insert(row);
  });
  suspects_ = broadcast(world, suspects_);
  on_all_ranks(world, [&] {
    run_collective(world.comm(), [&] {
      notes_.emplace(open.table, identity, world.rank());
      return std::uint64_t{0};
    });
  });
}

NotedRun::~NotedRun() {
  if (is_manager_) end_run_notes(open_.table, open_.ledger->is_complete());
}

}  // namespace sigmasweep
