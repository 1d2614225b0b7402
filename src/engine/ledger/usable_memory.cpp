#include "engine/ledger/usable_memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace sigmasweep {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number in a file of a control group; without limit if there is none ("max").
double limit_in(const std::string& path) {
  double bytes = unlimited;
  std::ifstream file(path);
  return file >> bytes ? bytes : unlimited;
}

/// The limits of the control group of this process and of those above it (cgroups(7)).
double limit_of_control_group() {
  double least = unlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool is_old = controllers.find("memory") != std::string::npos;
    if (!is_old && !controllers.empty()) continue;
    const std::string root = is_old ? "/sys/fs/cgroup/memory" : "/sys/fs/cgroup";
    const std::string name = is_old ? "/memory.limit_in_bytes" : "/memory.max";
    for (std::string group = line.substr(second + 1);; group.resize(group.rfind('/'))) {
      least = std::min(least, limit_in(fmt::format("{}{}{}", root, group, name)));
      if (group.find('/') == std::string::npos) break;
    }
  }
  return least;
}

}  // namespace

double usable_memory() {
  double least = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    least = std::min(least, double(limit.rlim_cur));
  return std::min(least, limit_of_control_group());
}

}  // namespace sigmasweep
