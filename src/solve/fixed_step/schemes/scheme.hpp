#pragma once

#include <concepts>
#include <cstddef>

#include "sigmasweep/model/parameters.hpp"
#include "solve/fixed_step/schemes/step_map.hpp"

/// The contract between schemes of fixed time step and the equations of motion that they integrate.
///
/// A scheme is a struct in a file of this folder: its traits, and a template Stepper<Equation> that makes the steps.
/// A new scheme needs its file, an entry in SchemeList (scheme_list.hpp), and an enumerator of Integrator with its
/// name.
namespace sigmasweep {

/// Run time of a scheme, s: of a step, and of each bead in it. Fitted to columns (N = 1 to 200) on an x86-64 with AVX2.
struct StepCost {
  double step = 0.0, bead = 0.0;
};

/// An equation of motion x'' = a(x, x', t) for a scheme, with time counted in steps, so that a scheme has no dt.
///     x, u             state at the start: components x and rates u = x'
///     components()     number of components
///     lanes()          the same, rounded up to whole vectors: a scheme may compute all of them
///     forces(x, u, F)  forces F of the contacts for a given state
///     drive(F, ahead)  adds the load of a moving ground, `ahead` steps after the step's start; after forces()
///     coupling.view()  .acceleration(F, k): acceleration of component k by the forces F
///     one_by_one       whether F_k depends on x_k and u_k only; if so contact()(k, x_k, u_k) is F_k
///     driven           whether the ground moves; if so first_acceleration() is a at the start
///     speed            initial speed of the beads, lengths a step
template <class E>
concept EquationOfMotion = requires(const E& equation, const double* in, double* out, std::size_t k) {
  { E::driven } -> std::convertible_to<bool>;
  { E::one_by_one } -> std::convertible_to<bool>;
  { equation.components() } -> std::same_as<std::size_t>;
  { equation.lanes() } -> std::same_as<std::size_t>;
  { equation.speed } -> std::convertible_to<double>;
  equation.forces(in, in, out);
  equation.drive(out, 0.5);
  { equation.coupling.view().acceleration(in, k) } -> std::same_as<double>;
};

/// The state that a scheme steps.
///     x(), u()      components and rates now
///     step()        makes one step
///     coasts()      whether the next steps are uniform motion while no contact closes
///     coast(n)      makes n such steps at once
///     touch(k)      sets component k to 0, a contact that just touches
template <class S>
concept SchemeStepper = requires(S& stepper, const S& now, std::size_t k) {
  { now.x() } -> std::same_as<const double*>;
  { now.u() } -> std::same_as<const double*>;
  { now.coasts() } -> std::same_as<bool>;
  stepper.step();
  stepper.coast(2.0);
  stepper.touch(k);
};

/// The traits of a scheme.
///     id               its Integrator
///     evaluations      evaluations of the forces in a step
///     cost             run time of a step
///     step_map(mode)   the step as a linear map of (x, x', ...) for a mode, time in steps
template <class S>
concept Scheme = requires(const Mode& mode) {
  { S::id } -> std::convertible_to<Integrator>;
  { S::evaluations } -> std::convertible_to<int>;
  { S::cost } -> std::convertible_to<StepCost>;
  { S::step_map(mode) } -> std::same_as<StepMap>;
};

}  // namespace sigmasweep
