#include "precision_references.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sigmasweep/scene/law.hpp"
#include "sigmasweep/scene/real.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "sigmasweep/solve/nonlinear.hpp"
#include "sigmasweep/solve/normal_modes.hpp"
#include "sigmasweep/solve/thread_clock.hpp"

namespace sigmasweep {
namespace {

/// References that differ by more than this are no references.
constexpr double chaos = 1e-9;
constexpr double settle = 1e-19;
/// About ten seconds of each: what takes longer is chaotic, and no reference.
constexpr std::uint64_t most_contacts_moved = 10'000'000, most_modes = 300'000'000;

using Reference = std::function<Answer(const Parameters&)>;

template <class Real>
Answer answer(const Outcome<Real>& outcome, const Column<Real>& column) {
  Answer a;
  a.known = outcome.status == Status::ok;
  if (!a.known) return a;
  a.eps_eff = static_cast<long double>(energies<Real>(outcome.velocity, column.speed, column.mass).eps_eff);
  for (const Real& v : outcome.velocity) a.velocity.push_back(static_cast<double>(v / column.speed));
  return a;
}

template <class Real>
Answer by_series(const Parameters& p) {
  const Column<Real> column = reduced_column<Real>(p);
  return answer<Real>(exact_collision(column, {.settle = settle, .work_limit = most_contacts_moved}), column);
}

Answer by_modes(const Parameters& p) {
  const auto column = reduced_column<long double>(p);
  return answer(normal_modes_collision(column, {.settle = settle, .work_limit = most_modes}), column);
}

Reference by_steps(double accuracy) {
  return [accuracy](const Parameters& p) {
    const auto column = reduced_column<long double>(p);
    return answer(nonlinear_collision(column, {.accuracy = accuracy, .settle = settle}), column);
  };
}

struct Pair {
  Reference all, check;
  bool check_is_better, independent;
};
Pair references_for(const Parameters& p) {
  if (!exponents(p).linear()) return {by_steps(1e-17), by_steps(1e-14), false, false};
  if (p.width > 0.0) return {by_series<long double>, by_series<Quad>, true, false};
  return {by_series<long double>, by_modes, false, true};
}

}  // namespace

/// Among tuples that are chaotic only checked ones can be compared; where none of the first few is, none will be.
bool References::worth_going_on(std::uint64_t most_checks) const {
  constexpr std::uint64_t few = 3;
  return chaotic == 0 || (checks < most_checks && (chaotic < checks || checks < few));
}

References find_references(const std::vector<Parameters>& tuples, const PrecisionSpec& spec) {
  const Pair pair = references_for(tuples.front());
  References found;
  found.independent = pair.independent;
  const double start = thread_seconds();
  for (std::size_t k = 0; k < tuples.size() && found.worth_going_on(spec.checks); ++k) {
    if (k > 0 && thread_seconds() - start > spec.seconds) break;
    Answer answer = pair.all(tuples[k]);
    bool agree = false;
    if (k < spec.checks) {
      Answer other = pair.check(tuples[k]);
      ++found.checks;
      const auto difference = static_cast<double>(std::fabs(other.eps_eff - answer.eps_eff));
      agree = other.known && answer.known && difference <= chaos;
      if (!agree) ++found.chaotic;
      else if (!(found.noise >= difference)) found.noise = difference;
      if (agree && pair.check_is_better) answer = std::move(other);
    }
    found.answers.push_back(std::move(answer));
    found.agreed.push_back(agree);
  }
  return found;
}

}  // namespace sigmasweep
