#pragma once

#include <mpi.h>

#include <cstdint>
#include <exception>
#include <string>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

/// The ranks that write a table together, on a communicator of their own. Every member function is collective.
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
  std::uint64_t max(std::uint64_t mine) const;
  /// Rank 0's text, on every rank.
  std::string broadcast(std::string text) const;
  std::uint64_t broadcast(std::uint64_t number) const;

  /// Does `step` on every rank, and throws on all if it threw on any: the error of the lowest such rank. If it threw on
  /// some and others are not through with it half a minute later, all ranks are ended.
  template <class Step>
  void together(Step&& step) const {
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
  std::string broadcast_from(int root, std::string text) const;
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

/// Throws IoError with MPI's own words unless `status` is MPI_SUCCESS.
void check_mpi(int status, const char* what);

}  // namespace sigmasweep
