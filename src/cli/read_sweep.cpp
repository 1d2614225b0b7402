#include "cli/read_sweep.hpp"

#include "cli/complain.hpp"

namespace sigmasweep {

StoredSweep read_sweep(const std::string& table) {
  StoredSweep stored = read_stored_sweep(table);
  if (const std::string line = incomplete_line(stored, table); !line.empty()) complain(line);
  return stored;
}

}  // namespace sigmasweep
