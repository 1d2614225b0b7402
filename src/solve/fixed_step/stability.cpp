#include "solve/fixed_step/stability.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "contact/contact_law.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/law.hpp"
#include "solve/fixed_step/lattice/modes.hpp"
#include "solve/fixed_step/scheme_info.hpp"
#include "solve/fixed_step/spectral_radius.hpp"

namespace sigmasweep {
namespace {

constexpr double rounding = 1e-9;  // of the spectral radius

/// Sum of the magnitudes in row i of the matrix A diag(K).
double row_sum(const Column<double>& column, std::size_t i, double (Column<double>::*K)(std::size_t) const) {
  double sum = column.inertia(i) * (column.*K)(i);
  if (i > 0) sum += column.inverse_mass(i - 1) * (column.*K)(i - 1);
  if (i + 1 < column.contacts()) sum += column.inverse_mass(i) * (column.*K)(i + 1);
  return sum;
}

/// The linearised force F = K x^(1+beta) + C x^gamma x', for K = 1 and C = 1, at the largest overlap of a mean bead
/// that hits the wall at the column's speed v without damping: m v^2/2 = K x^(2+beta)/(2+beta).
Mode about_overlap(const Column<double>& column) {
  const double beta = column.exponents.beta;
  const double x = std::pow((2.0 + beta) * column.speed * column.speed / (2.0 * column.K_wall), 1.0 / (2.0 + beta));
  const Tangent about = tangent(column.exponents, x);
  return {about.spring, about.dashpot};
}

}  // namespace

double growth_per_step(Integrator integrator, const Mode& mode) {
  return spectral_radius(scheme_info(integrator).step_map(mode));
}

/// The overlaps obey x'' = -A (K x + C x') with A = tridiag(-1/m_(k-1), 1/m_(k-1) + 1/m_k, -1/m_k); K and C are
/// diagonal.
ClosedContacts closed_contacts(const Column<double>& column) {
  const auto height = static_cast<double>(column.N);
  const Mode single = about_overlap(column);
  if (column.is_uniform() && (column.K_wall == column.K || column.N == 1)) {
    const double lambda = 2.0 + 2.0 * std::cos(2.0 * std::numbers::pi / (2.0 * height + 1.0));
    return {{{lambda * single.k * column.K_wall, lambda * single.c * column.C_wall}}, column.tc, height};
  }
  Mode bound;
  for (std::size_t i = 0; i < column.contacts(); ++i) {
    bound.k = std::max(bound.k, row_sum(column, i, &Column<double>::spring));
    bound.c = std::max(bound.c, row_sum(column, i, &Column<double>::dashpot));
  }
  return {{{single.k * bound.k, single.c * bound.c}}, column.tc, height};
}

ClosedContacts closed_contacts(const Lattice<double>& lattice) {
  const Column<double>& beads = lattice.beads;
  const Mode single = about_overlap(beads);
  ClosedContacts closed{{}, beads.tc, static_cast<double>(lattice.rows)};
  for (const ModalCoefficients& most : largest_shares(lattice))
    closed.modes.push_back(
        {most.spring * single.k * beads.K, most.dashpot * single.c * beads.C + most.friction * lattice.D_t});
  return closed;
}

ClosedContacts closed_contacts(const Parameters& p) {
  const double speed = is_vibrated(p) ? p.A0 * 2.0 * std::numbers::pi * p.frequency / p.v0 : 1.0;
  if (!is_lattice(p)) {
    Column<double> column = reduced_column<double>(p);
    column.speed = speed;
    return closed_contacts(column);
  }
  Lattice<double> lattice = reduced_lattice<double>(p);
  lattice.beads.speed = speed;
  return closed_contacts(lattice);
}

StabilitySignature stability_signature(const Parameters& p) {
  StabilitySignature signature;
  const auto add = [&](double value) { signature.push_back(std::bit_cast<std::uint64_t>(value + 0.0)); };  // -0 is 0
  const auto add_whole = [&](std::int64_t value) { signature.push_back(static_cast<std::uint64_t>(value)); };
  for (const double value : {p.epsilon, p.beta, p.gamma}) add(value);
  for (const std::int64_t value : {p.N, static_cast<std::int64_t>(p.law), static_cast<std::int64_t>(p.wall)})
    add_whole(value);
  const bool given_stiffness = p.K_over_m > 0.0, unequal = p.width > 0.0, lattice = is_lattice(p);
  const bool given_speed = is_vibrated(p) && !exponents(p).linear();
  for (const bool feature : {given_stiffness, unequal, lattice, given_speed}) add_whole(feature);
  if (given_stiffness)
    for (const double value : {p.K_over_m, p.D_n, p.v0, p.tc}) add(value);
  if (unequal) {
    add(p.width);
    add(p.d);
    add_whole(p.seed);
  }
  if (lattice) {
    add_whole(p.rows);
    add_whole(static_cast<std::int64_t>(p.side_walls));
    add(p.D_t * p.tc);
  }
  if (given_speed)
    for (const double value : {p.A0, p.frequency, p.v0}) add(value);
  return signature;
}

bool has_searched_motions(const Parameters& p) { return is_lattice(p) && p.width > 0.0; }

double growth_in_a_contact(const ClosedContacts& closed, Integrator integrator, double dt) {
  double growth = 0.0;
  for (const Mode& mode : closed.modes) {
    const double radius = growth_per_step(integrator, mode.in_steps(dt));
    growth = std::max(growth, std::fabs(radius - 1.0) <= rounding ? 1.0 : std::pow(radius, closed.tc / dt));
  }
  return growth;
}

double predicted_growth(const ClosedContacts& closed, Integrator integrator, double dt) {
  return std::pow(growth_in_a_contact(closed, integrator, dt), closed.height);
}

double predicted_growth(const Parameters& p) {
  return predicted_growth(closed_contacts(p), p.integrator, 1.0 / p.steps_per_tc);
}

bool is_stable(const ClosedContacts& closed, Integrator integrator, double dt) {
  return predicted_growth(closed, integrator, dt) <= max_stable_growth;
}

bool is_stable(const Parameters& p) { return predicted_growth(p) <= max_stable_growth; }

}  // namespace sigmasweep
