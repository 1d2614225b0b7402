#include "solve/fixed_step/stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sigmasweep/model/geometry.hpp"
#include "solve/fixed_step/lattice/modes.hpp"

namespace sigmasweep {
namespace {

/// Wide numbers: where the step is short two eigenvalues e^(+-i omega dt) nearly meet, and lose half of the digits.
using Wide = long double;
/// Up to 6 x 6. Sizes are told at run time: unrolled, this would take a minute to compile.
using Map = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// Predict with Pascal's triangle, correct with D = a/2 - p_2 (fixed_step_gear5.hpp).
Map gear5_map(const Mode& mode) {
  Map predict = Map::Zero(6, 6);
  for (int n = 0; n < 6; ++n)
    for (int m = n; m < 6; ++m) predict(n, m) = m == n || n == 0 ? Wide(1) : predict(n - 1, m - 1) + predict(n, m - 1);
  constexpr std::array<Wide, 6> correct{3.0L / 16, 251.0L / 360, 1.0L, 11.0L / 18, 1.0L / 6, 1.0L / 60};
  Map map = predict;
  for (int m = 0; m < 6; ++m) {
    const Wide D = -(mode.k * predict(0, m) + mode.c * predict(1, m)) / 2 - predict(2, m);
    for (int n = 0; n < 6; ++n) map(n, m) += correct[static_cast<std::size_t>(n)] * D;
  }
  return map;
}

/// Of (x, u, a): x += u + a/2, then a_new = -k x - c (u + a), u += (a + a_new)/2.
Map verlet_map(const Mode& mode) {
  const Wide k = mode.k, c = mode.c;
  const std::array<Wide, 3> a{-k, -k - c, -k / 2 - c};
  Map map(3, 3);
  map << 1, 1, Wide(1) / 2,                    //
      a[0] / 2, 1 + a[1] / 2, (1 + a[2]) / 2,  //
      a[0], a[1], a[2];
  return map;
}

/// 1 + M + M^2/2 + M^3/6 + M^4/24 for (x, u)' = M (x, u), where M^2 = -k - c M and so M^n = p + q M.
Map rk4_map(const Mode& mode) {
  const Wide k = mode.k, c = mode.c;
  Wide p = 1, q = 0, P = 1, Q = 0, factor = 1;
  for (int n = 1; n <= 4; ++n) {
    const Wide before = p;
    p = -k * q;
    q = before - c * q;
    factor /= n;
    P += factor * p;
    Q += factor * q;
  }
  Map map(2, 2);
  map << P, Q, -k * Q, P - c * Q;  // P + Q M
  return map;
}

Map map_of(Integrator integrator, const Mode& mode) {
  switch (integrator) {
    case Integrator::gear5: return gear5_map(mode);
    case Integrator::verlet: return verlet_map(mode);
    case Integrator::rk4: return rk4_map(mode);
    case Integrator::exact: break;
  }
  throw std::invalid_argument("stability: not an integrator of fixed step");
}

double spectral_radius(const Map& map) {
  if (!map.allFinite()) return std::numeric_limits<double>::infinity();
  return static_cast<double>(Eigen::EigenSolver<Map>(map, false).eigenvalues().cwiseAbs().maxCoeff());
}

constexpr double rounding = 1e-9;  // of the spectral radius

/// Of the matrix A diag(K), a row's sum of magnitudes.
double row_sum(const Column<double>& column, std::size_t i, double (Column<double>::*K)(std::size_t) const) {
  double sum = column.inertia(i) * (column.*K)(i);
  if (i > 0) sum += column.inverse_mass(i - 1) * (column.*K)(i - 1);
  if (i + 1 < column.contacts()) sum += column.inverse_mass(i) * (column.*K)(i + 1);
  return sum;
}

/// Of the law's F = K x^(1+beta) + C x^gamma x', for a small motion about the overlap that m v^2/2 = K
/// x^(2+beta)/(2+beta) gives a mean bead at the wall: k for K = 1, and c for C = 1.
Mode about_overlap(const Column<double>& column) {
  const auto [beta, gamma] = column.exponents;
  const double x = std::pow((2.0 + beta) * column.speed * column.speed / (2.0 * column.K_wall), 1.0 / (2.0 + beta));
  return {(1.0 + beta) * std::pow(x, beta), std::pow(x, gamma)};
}

}  // namespace

double growth_per_step(Integrator integrator, const Mode& mode) { return spectral_radius(map_of(integrator, mode)); }

std::vector<double> step_map(Integrator integrator, const Mode& mode) {
  const Map map = map_of(integrator, mode);
  std::vector<double> rows;
  for (Eigen::Index i = 0; i < map.rows(); ++i)
    for (Eigen::Index j = 0; j < map.cols(); ++j) rows.push_back(static_cast<double>(map(i, j)));
  return rows;
}

/// The overlaps obey x'' = -A (K x + C x'), A = tridiag(-1/m_(k-1), 1/m_(k-1) + 1/m_k, -1/m_k), K and C diagonal.
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
