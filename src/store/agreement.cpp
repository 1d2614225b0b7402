#include "agreement.hpp"

#include <fmt/format.h>

#include <array>

namespace sigmasweep {

void check_mpi(int status, const char* what) {
  if (status == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  if (MPI_Error_string(status, text.data(), &length) != MPI_SUCCESS) length = 0;
  throw IoError(fmt::format("{}: {}", what, std::string_view(text.data(), static_cast<std::size_t>(length))));
}

Team::Team(MPI_Comm comm) {
  check_mpi(MPI_Comm_dup(comm, &comm_), "cannot copy the communicator");
  check_mpi(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN), "cannot set the error handler");
  check_mpi(MPI_Comm_rank(comm_, &rank_), "cannot get the rank");
  check_mpi(MPI_Comm_size(comm_, &size_), "cannot get the number of ranks");
}

Team::~Team() { MPI_Comm_free(&comm_); }

std::uint64_t Team::sum(std::uint64_t mine) const {
  std::uint64_t all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, comm_), "cannot add over the ranks");
  return all;
}

std::uint64_t Team::max(std::uint64_t mine) const {
  std::uint64_t all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_MAX, comm_), "cannot compare over the ranks");
  return all;
}

std::uint64_t Team::broadcast(std::uint64_t number) const {
  check_mpi(MPI_Bcast(&number, 1, MPI_UINT64_T, 0, comm_), "cannot broadcast");
  return number;
}

std::string Team::broadcast(std::string text) const { return broadcast_from(0, std::move(text)); }

std::string Team::broadcast_from(int root, std::string text) const {
  std::uint64_t size = text.size();
  check_mpi(MPI_Bcast(&size, 1, MPI_UINT64_T, root, comm_), "cannot broadcast");
  text.resize(size);
  check_mpi(MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, root, comm_), "cannot broadcast");
  return text;
}

void Team::agree(int exit_code, std::string message) const {
  int failed = exit_code == 0 ? size_ : rank_;
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm_), "cannot agree");
  if (failed == size_) return;
  check_mpi(MPI_Bcast(&exit_code, 1, MPI_INT, failed, comm_), "cannot agree");
  message = broadcast_from(failed, std::move(message));
  if (exit_code == OutputError("").exit_code()) throw OutputError(message);
  throw IoError(message);
}

}  // namespace sigmasweep
