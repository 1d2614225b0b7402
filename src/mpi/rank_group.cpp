#include "mpi/rank_group.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

namespace sigmasweep {

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

std::uint64_t RankGroup::sum_before(std::uint64_t mine) const {
  std::uint64_t before = 0;
  check_mpi(MPI_Exscan(&mine, &before, 1, MPI_UINT64_T, MPI_SUM, comm_), "cannot add over the ranks");
  return rank_ == 0 ? 0 : before;
}

std::uint64_t RankGroup::max(std::uint64_t mine) const {
  std::uint64_t all = 0;
  check_mpi(MPI_Allreduce(&mine, &all, 1, MPI_UINT64_T, MPI_MAX, comm_), "cannot compare over the ranks");
  return all;
}

/// Waits until all ranks have reached this point. A rank that failed does not wait for ever: if it left a collective
/// call early, the others are still in that call. Unwinding would not help, because closing a file that the ranks have
/// open together waits for them too. So here, and nowhere else in the libraries, the error is printed and all ranks are
/// ended.
void RankGroup::wait_for_all(MPI_Request request, int exit_code, const std::string& message) const {
  if (exit_code == 0) return check_mpi(MPI_Wait(&request, MPI_STATUS_IGNORE), "cannot agree");
  constexpr auto patience = std::chrono::seconds(30);
  const auto end = std::chrono::steady_clock::now() + patience;
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
  exit_code = sigmasweep::broadcast(comm_, exit_code, failed);
  message = sigmasweep::broadcast(comm_, std::move(message), failed);
  if (exit_code == OutputError("").exit_code()) throw OutputError(message);
  throw IoError(message);
}

}  // namespace sigmasweep
