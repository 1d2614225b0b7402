#pragma once

#include <span>
#include <string_view>

#include "sigmasweep/base/budget.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/result.hpp"
#include "sigmasweep/model/trajectory.hpp"

/// The table of solvers: all that the rest of the program knows of how a tuple is computed.
namespace sigmasweep {

/// A solver of one geometry. Its entry stands in the solver's folder, in solver.cpp.
struct Solver {
  std::string_view name;
  Assembly assembly;
  GroundKind ground;
  /// Whether it solves this tuple, if the geometry is the solver's.
  bool (*accepts)(const Parameters&);
  /// The result of a valid tuple. Asks the budget now and then, if there is one, and then gives up. May throw.
  SimulationResult (*run)(const Parameters&, ComputeBudget*);
  /// Positions and velocities of all beads at `times` (s, ascending, from the start): see record().
  Trajectory (*observe)(const Parameters&, std::span<const double> times);
  /// CPU time that run() takes, s. A finite number > 0 for invalid tuples, too.
  double (*predicted_seconds)(const Parameters&);
  /// Duration of a film of the run with this result, s: see show_time().
  double (*film_duration)(const Parameters&, const SimulationResult&);
  /// Results of several tuples that the solver solves, one for each, the same bits as run(). A tuple that takes long is
  /// left with Status::not_run, and run() is called for it, with its budget. None: run() is called for one tuple after
  /// the other.
  void (*run_many)(std::span<const Parameters>, std::span<SimulationResult>) = nullptr;

  bool solves(const Parameters& p) const {
    const GeometryInfo& geometry = geometry_of(p);
    return geometry.assembly == assembly && geometry.ground == ground && accepts(p);
  }
};

/// All solvers. A new one is declared below and has its line in solvers.cpp.
std::span<const Solver* const> solvers();

/// The first of them that solves the tuple. Every tuple has one, invalid ones, too.
const Solver& solver_of(const Parameters& parameters);

extern const Solver lattice_events, lattice_events_on_plate;
extern const Solver hard_spheres, hard_spheres_on_plate;
extern const Solver linear_column, linear_column_on_plate;
extern const Solver power_law_column, power_law_column_on_plate;
extern const Solver fixed_step_column, fixed_step_column_on_plate;
extern const Solver fixed_step_lattice, fixed_step_lattice_on_plate;

}  // namespace sigmasweep
