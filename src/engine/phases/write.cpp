#include "engine/phases/write.hpp"

#include <optional>
#include <string>
#include <vector>

#include "engine/phases/phase.hpp"
#include "engine/rows/row_collector.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/last_resort.hpp"
#include "mpi/rank_group.hpp"
#include "store/journal/names.hpp"
#include "store/table/write.hpp"

namespace sigmasweep {
namespace {

/// The journals that this rank reads: its own, and its share of those that a run with more ranks has left. Collective.
std::vector<std::string> journals_to_read(const World& world, const std::string& table) {
  std::string others;  // a number a line
  on_manager(world, [&] {
    for (const int rank : other_ranks_with_journals(table))
      if (rank >= world.size()) others += std::to_string(rank) + "\n";
  });
  others = world.broadcast(std::move(others));
  std::vector<std::string> mine{journal_of_rank(table, world.rank())};
  for (std::size_t begin = 0; begin < others.size();) {
    const std::size_t end = others.find('\n', begin);
    if (const int rank = std::stoi(others.substr(begin, end - begin)); rank % world.size() == world.rank())
      mine.push_back(journal_of_rank(table, rank));
    begin = end + 1;
  }
  return mine;
}

}  // namespace

void write_rows(const World& world, const OpenSweep& open) {
  const LastResort::Together together;
  LastResort::allow(
      time_for_the_end(0.0, double(open.rows()) * double(sizeof(Row))));  // it is finished after a stop, too
  const std::vector<std::string> journals = journals_to_read(world, open.table);
  on_all_ranks(world, [&] {
    const RankGroup ranks(world.comm());
    RowCollector collector(ranks, open.sweep, open.slice, journals);
    write_table(world.comm(), open.table, open.info(world), open.sweep.columns(), open.rows(), collector.block());
  });
  LastResort::allow(0.0);
}

}  // namespace sigmasweep
