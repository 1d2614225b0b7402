#include "engine/phases/write.hpp"

#include <vector>

#include "engine/phases/phase.hpp"
#include "engine/report/provenance.hpp"
#include "engine/stop/deadline.hpp"
#include "engine/stop/last_resort.hpp"
#include "store/table/write.hpp"

namespace sigmasweep {

void write_rows(const World& world, const OpenSweep& open) {
  TableInfo info = table_info(open.sweep, open.start, world.size());  // the manager's counts
  info.slice = open.slice;
  const auto first = world.block(open.rows()).first;
  const std::vector<Row> block = world.scatter(open.manager_rows(), open.rows());
  LastResort::allow(
      time_for_the_end(0.0, double(open.rows()) * double(sizeof(Row))));  // it is finished after a stop, too
  on_all_ranks(world,
               [&] { write_table(world.comm(), open.table, info, open.sweep.columns(), open.rows(), first, block); });
  LastResort::allow(0.0);
}

}  // namespace sigmasweep
