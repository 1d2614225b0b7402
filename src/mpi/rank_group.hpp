#pragma once

#include <mpi.h>

#include <cstdint>
#include <exception>
#include <string>

#include "mpi/broadcast.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

/// The ranks that do a piece of work together, such as writing a table, on a communicator of their own. Every member
/// function is collective.
class RankGroup {
 public:
  explicit RankGroup(MPI_Comm comm);
  ~RankGroup();
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;
  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }

  std::uint64_t sum(std::uint64_t mine) const;
  /// Of the ranks before this one.
  std::uint64_t sum_before(std::uint64_t mine) const;
  std::uint64_t max(std::uint64_t mine) const;
  /// Rank 0's number or text, on every rank.
  std::uint64_t broadcast(std::uint64_t number) const { return sigmasweep::broadcast(comm_, number); }
  std::string broadcast(std::string text) const { return sigmasweep::broadcast(comm_, std::move(text)); }

  /// Runs `step` on every rank. If it throws on any rank, every rank throws the error of the lowest such rank, as
  /// OutputError or IoError. If some ranks failed and others have not finished half a minute later, all ranks are
  /// ended.
  template <class Step>
  void run_collective(Step&& step) const {
    int exit_code = 0;
    std::string message;
    try {
      step();
    } catch (const Error& error) {
      exit_code = error.exit_code();
      message = error.what();
    } catch (const std::exception& error) {
      exit_code = IoError("").exit_code();
      message = error.what();
    }
    agree(exit_code, std::move(message));
  }

 private:
  void agree(int exit_code, std::string message) const;
  void wait_for_all(MPI_Request request, int exit_code, const std::string& message) const;
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

}  // namespace sigmasweep
