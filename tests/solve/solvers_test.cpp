#include "solve/solvers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "sigmasweep/model/names.hpp"
#include "sigmasweep/solve/simulate.hpp"
#include "support/parameters.hpp"

using namespace sigmasweep;

namespace {

constexpr std::array geometries_of_all{Geometry::column, Geometry::vibrated_column, Geometry::lattice,
                                       Geometry::vibrated_lattice};

Parameters small(Geometry geometry, Method method, Integrator integrator, Law law) {
  Parameters p;
  p.geometry = geometry;
  p.method = method;
  p.integrator = integrator;
  p.law = law;
  p.N = 3;
  p.rows = p.columns = 2;
  p.sigma = 0.3;
  p.tolerance = 1e-6;
  p.alpha = 1.5;
  p.tc = 1e-3;
  p.periods = 3;
  p.transient = 1;
  return completed(p);
}

/// Every geometry, method, integrator and law; some of them are invalid together.
std::vector<Parameters> all_kinds() {
  std::vector<Parameters> all;
  for (const Geometry geometry : geometries_of_all)
    for (const Method method : {Method::md, Method::ed})
      for (const Integrator integrator : values_of<Integrator>())
        for (const Law law : {Law::hooke, Law::hertz}) all.push_back(small(geometry, method, integrator, law));
  return all;
}

}  // namespace

TEST(Solvers, EveryTupleHasExactlyOne) {
  for (const Parameters& p : all_kinds()) {
    int found = 0;
    for (const Solver* solver : solvers()) found += solver->solves(p);
    EXPECT_EQ(found, 1) << solver_of(p).name;
  }
}

TEST(Solvers, EachIsComplete) {
  for (const Solver* solver : solvers()) {
    EXPECT_FALSE(solver->name.empty());
    EXPECT_TRUE(solver->accepts && solver->run && solver->observe && solver->predicted_seconds && solver->film_duration)
        << solver->name;
  }
}

TEST(Solvers, ManyTuplesAtOnceHaveTheBitsOfOneByOne) {
  std::vector<Parameters> tuples = all_kinds();
  tuples[5].v0 = -1.0;  // invalid
  std::vector<SimulationResult> results(tuples.size());
  simulate_many(tuples, results);
  int successes = 0;
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    const SimulationResult alone = simulate(tuples[i]);
    EXPECT_EQ(std::memcmp(&alone, &results[i], offsetof(SimulationResult, status) + sizeof(Status)), 0) << i;
    successes += is_success(alone.status);
  }
  EXPECT_GT(successes, 40);
  EXPECT_EQ(results[5].status, Status::failed);
}

TEST(Solvers, OneResultForEachTuple) {
  const std::vector<Parameters> tuples(2);
  std::vector<SimulationResult> results(1);
  EXPECT_THROW(simulate_many(tuples, results), std::invalid_argument);
}
