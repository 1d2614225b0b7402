#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

/// What manager and workers say to each other: a tag and an array of plain structs, sent as their bytes. All ranks run
/// the same program on the same kind of machine, so bytes are exact, and six times faster than serialised objects.
namespace sigmasweep::message {

enum Tag : int {
  chunk,    ///< manager to worker: tuples to compute, after those it still has
  quit,     ///< manager to worker: begin no tuple any more, say farewell
  rows,     ///< worker to manager: finished rows
  stop,     ///< worker to manager: this rank was asked to stop
  farewell  ///< worker to manager: the last finished rows; nothing follows
};

inline constexpr int manager_rank = 0;

/// The bytes of `items`; Boost.MPI binds a reference to the first one, so there is one even when there are no items.
template <class T>
auto* bytes_of(T* items) {
  static_assert(std::is_trivially_copyable_v<T>);
  using Byte = std::conditional_t<std::is_const_v<T>, const unsigned char, unsigned char>;
  static unsigned char none = 0;
  return items ? reinterpret_cast<Byte*>(items) : static_cast<Byte*>(&none);
}

/// `items` must stay alive and unchanged until the request is done.
template <class T>
boost::mpi::request send(const boost::mpi::communicator& to, int rank, Tag tag, std::span<const T> items) {
  return to.isend(rank, tag, bytes_of(items.data()), static_cast<int>(items.size_bytes()));
}

/// Receives the message that a probe announced.
template <class T>
std::vector<T> receive(const boost::mpi::communicator& from, const boost::mpi::status& announced) {
  const auto bytes = static_cast<std::size_t>(announced.count<unsigned char>().value());
  std::vector<T> items(bytes / sizeof(T));
  from.recv(announced.source(), announced.tag(), bytes_of(items.data()), static_cast<int>(bytes));
  return items;
}

}  // namespace sigmasweep::message
