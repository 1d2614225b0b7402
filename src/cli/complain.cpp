#include "cli/complain.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace sigmasweep {

int launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* rank = std::getenv(name)) return std::atoi(rank);
  return 0;
}

void complain(const std::string& message) {
  if (launched_rank() == 0) fmt::print(stderr, "sigmasweep: {}\n", message);
}

}  // namespace sigmasweep
