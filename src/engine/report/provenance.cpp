#include "engine/report/provenance.hpp"

#include <fmt/chrono.h>
#include <unistd.h>

#include <chrono>

namespace sigmasweep {

std::string host_name() {
  char name[256] = "";
  return gethostname(name, sizeof name - 1) == 0 ? name : "?";
}

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now())); }

TableInfo table_info(const Sweep& sweep, const std::string& start, int ranks) {
  TableInfo info;
  info.title = sweep.title();
  info.spec_text = sweep.text();
  info.spec_hash = sweep.hash();
  info.host = host_name();
  info.start = start;
  info.ranks = ranks;
  return info;
}

}  // namespace sigmasweep
