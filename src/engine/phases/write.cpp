#include "engine/phases/write.hpp"

#include "engine/phases/phase.hpp"
#include "engine/report/provenance.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/last_resort.hpp"
#include "store/table/write.hpp"

namespace sigmasweep {

void write_rows(const World& world, const OpenSweep& open) {
  const LastResort::Together together;
  TableInfo info = table_info(open.sweep, open.start, world.size());  // the manager's counts
  info.slice = open.slice;
  const auto [first, count] = world.block(open.rows());
  PackedRows received(open.sweep.columns(), world.is_manager() ? 0 : count);
  const PackedRows& mine = world.is_manager() ? open.ledger->packed() : received;
  world.scatter(mine.results().bytes, mine.results().row_size, open.rows(), received.results().bytes);
  world.scatter(mine.timings().bytes, mine.timings().row_size, open.rows(), received.timings().bytes);
  const PackedBlock block(first, mine, count);
  LastResort::allow(
      time_for_the_end(0.0, double(open.rows()) * double(sizeof(Row))));  // it is finished after a stop, too
  on_all_ranks(world, [&] { write_table(world.comm(), open.table, info, open.sweep.columns(), open.rows(), block); });
  LastResort::allow(0.0);
}

}  // namespace sigmasweep
