#include "mpi/exchange.hpp"

#include "mpi/broadcast.hpp"

namespace sigmasweep {
namespace {

/// Where each message begins, and behind the last one the sum.
std::vector<int> places_of(const std::vector<int>& sizes) {
  std::vector<int> places(1, 0);
  for (const int size : sizes) places.push_back(places.back() + size);
  return places;
}

}  // namespace

std::vector<std::byte> exchange(MPI_Comm comm, std::span<const std::vector<std::byte>> to_each) {
  constexpr const char* action = "cannot exchange rows";
  std::vector<int> sent, received(to_each.size());
  std::vector<std::byte> out;
  for (const auto& bytes : to_each) {
    sent.push_back(static_cast<int>(bytes.size()));
    out.insert(out.end(), bytes.begin(), bytes.end());
  }
  check_mpi(MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, comm), action);
  const std::vector<int> from = places_of(sent), to = places_of(received);
  std::vector<std::byte> in(static_cast<std::size_t>(to.back()));
  check_mpi(MPI_Alltoallv(out.data(), sent.data(), from.data(), MPI_BYTE, in.data(), received.data(), to.data(),
                          MPI_BYTE, comm),
            action);
  return in;
}

}  // namespace sigmasweep
