#pragma once

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include "mpi/world.hpp"

namespace sigmasweep {

struct World::Impl {
  Impl(int& argc, char**& argv)
      : environment(argc, argv, boost::mpi::threading::funneled, /*abort_on_exception=*/false) {}

  boost::mpi::environment environment;
  boost::mpi::communicator communicator;
};

}  // namespace sigmasweep
