#include "mpi/collective.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <thread>

namespace sigmasweep {

void check_mpi(int status, const char* what) {
  if (status == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  if (MPI_Error_string(status, text.data(), &length) != MPI_SUCCESS) length = 0;
  throw IoError(fmt::format("{}: {}", what, std::string_view(text.data(), static_cast<std::size_t>(length))));
}

RankGroup::RankGroup(MPI_Comm comm) {
  check_mpi(MPI_Comm_dup(comm, &comm_), "cannot copy the communicator");
  check_mpi(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN), "cannot set the error handler");
  check_mpi(MPI_Comm_rank(comm_, &rank_), "cannot get the rank");
  check_mpi(MPI_Comm_size(comm_, &size_), "cannot get the number of ranks");
}

RankGroup::~RankGroup() { MPI_Comm_free(&comm_); }

std::uint64_t RankGroup::sum(std::uint64_t mine) const {
  std::uint64_t all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_SUM, comm_), "cannot add over the ranks");
  return all;
}

std::uint64_t RankGroup::max(std::uint64_t mine) const {
  std::uint64_t all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_MAX, comm_), "cannot compare over the ranks");
  return all;
}

std::uint64_t RankGroup::broadcast(std::uint64_t number) const {
  check_mpi(MPI_Bcast(&number, 1, MPI_UINT64_T, 0, comm_), "cannot broadcast");
  return number;
}

std::string RankGroup::broadcast(std::string text) const { return broadcast_from(0, std::move(text)); }

std::string RankGroup::broadcast_from(int root, std::string text) const {
  std::uint64_t size = text.size();
  check_mpi(MPI_Bcast(&size, 1, MPI_UINT64_T, root, comm_), "cannot broadcast");
  text.resize(size);
  check_mpi(MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, root, comm_), "cannot broadcast");
  return text;
}

/// Until all ranks have come. A rank that failed does not wait for ever: if it left a collective call early, the others
/// are still in there. To unwind would not help, as closing a file that is open together waits for them too; so here,
/// and nowhere else in the library, the error is printed and all ranks are ended.
void RankGroup::wait_for_all(MPI_Request request, int exit_code, const std::string& message) const {
  if (exit_code == 0) return check_mpi(MPI_Wait(&request, MPI_STATUS_IGNORE), "cannot agree");
  constexpr auto budget = std::chrono::seconds(30);
  const auto end = std::chrono::steady_clock::now() + budget;
  for (int done = 0;;) {
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "cannot agree");
    if (done) return;
    if (std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::fputs(fmt::format("sigmasweep: rank {}: {} (and the other ranks do not answer: all are ended)\n", rank_, message)
                 .c_str(),
             stderr);
  MPI_Abort(comm_, exit_code);
}

void RankGroup::agree(int exit_code, std::string message) const {
  int failed = exit_code == 0 ? size_ : rank_;
  MPI_Request request = MPI_REQUEST_NULL;
  check_mpi(MPI_Iallreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm_, &request), "cannot agree");
  wait_for_all(request, exit_code, message);
  if (failed == size_) return;
  check_mpi(MPI_Bcast(&exit_code, 1, MPI_INT, failed, comm_), "cannot agree");
  message = broadcast_from(failed, std::move(message));
  if (exit_code == OutputError("").exit_code()) throw OutputError(message);
  throw IoError(message);
}

}  // namespace sigmasweep
