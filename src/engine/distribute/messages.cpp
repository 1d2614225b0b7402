#include "engine/distribute/messages.hpp"

namespace sigmasweep::message {
namespace {

/// Boost.MPI binds a reference to the first byte, so there is one even when there are no bytes.
unsigned char none = 0;

}  // namespace

boost::mpi::request send(const boost::mpi::communicator& to, int rank, Tag tag, std::span<const std::byte> bytes) {
  const auto* first = bytes.empty() ? &none : reinterpret_cast<const unsigned char*>(bytes.data());
  return to.isend(rank, tag, first, static_cast<int>(bytes.size()));
}

wire::Bytes receive(const boost::mpi::communicator& from, const boost::mpi::status& announced) {
  wire::Bytes bytes(static_cast<std::size_t>(announced.count<unsigned char>().value()));
  auto* first = bytes.empty() ? &none : reinterpret_cast<unsigned char*>(bytes.data());
  from.recv(announced.source(), announced.tag(), first, static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace sigmasweep::message
