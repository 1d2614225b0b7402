#include "cli/launcher.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace sigmasweep {
namespace {

/// Variables with the number of processes that were started together.
constexpr std::array size_variables{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", "SLURM_STEP_NUM_TASKS"};

/// 0 if the variable is not there.
int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 0 : std::atoi(text);
}

/// "Open MPI v4.1.4"
std::string mpi_library() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  if (MPI_Get_library_version(text.data(), &length) != MPI_SUCCESS) return "its MPI";
  const std::string_view version(text.data());
  return std::string(version.substr(0, version.find_first_of(",\n")));
}

}  // namespace

int launched_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* rank = std::getenv(name)) return std::atoi(rank);
  return 0;
}

std::string why_wrong_launcher(int mpi_size) {
  if (mpi_size > 1) return {};
  // A launcher of one process within one of several: mpirun -n 1 in a step of srun.
  if (std::ranges::any_of(size_variables, [](const char* variable) { return number_in(variable) == 1; })) return {};
  const auto several =
      std::ranges::find_if(size_variables, [](const char* variable) { return number_in(variable) > 1; });
  if (several == size_variables.end()) return {};
  return fmt::format(
      "{} = {}, but this process is alone for {}: the launcher is of another MPI than the program. Start it with the "
      "mpirun of {} (or srun --mpi=pmix), or unset {} where each process is a run of its own",
      *several, number_in(*several), mpi_library(), mpi_library(), *several);
}

}  // namespace sigmasweep
