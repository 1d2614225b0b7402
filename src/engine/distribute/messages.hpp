#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <cstddef>
#include <span>

#include "engine/distribute/wire.hpp"

/// Messages between manager and workers: a tag and bytes.
namespace sigmasweep::message {

enum Tag : int {
  chunk,         ///< manager to worker: tasks to compute, after those it still has
  give_back,     ///< manager to worker: give back half of the tasks that are not begun
  quit,          ///< manager to worker: begin no further task, send the last answers; nothing follows
  answers,       ///< worker to manager: answers of finished tasks
  given_back,    ///< worker to manager: so many tasks are given back, the last that it got
  stop,          ///< worker to manager: this rank was asked to stop
  last_answers,  ///< worker to manager: the last answers; nothing follows
};

inline constexpr int manager_rank = 0;

/// `bytes` must stay alive and unchanged until the request is done.
boost::mpi::request send(const boost::mpi::communicator& to, int rank, Tag tag, std::span<const std::byte> bytes);

/// Receives the message that a probe announced.
wire::Bytes receive(const boost::mpi::communicator& from, const boost::mpi::status& announced);

}  // namespace sigmasweep::message
