#include "sigmasweep/solve/stability.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace sigmasweep {
namespace {

/// Wide numbers: where the step is short two eigenvalues e^(+-i omega dt) nearly meet, and lose half of the digits.
using Wide = long double;
template <int n>
using Map = Eigen::Matrix<Wide, n, n>;

/// Predict with Pascal's triangle, correct with D = a/2 - p_2 (fixed_step_gear5.hpp).
Map<6> gear5_map(const Mode& mode) {
  Map<6> predict = Map<6>::Zero();
  for (int n = 0; n < 6; ++n)
    for (int m = n; m < 6; ++m) predict(n, m) = m == n || n == 0 ? Wide(1) : predict(n - 1, m - 1) + predict(n, m - 1);
  Eigen::Matrix<Wide, 6, 1> correct;
  correct << Wide(3) / 16, Wide(251) / 360, 1, Wide(11) / 18, Wide(1) / 6, Wide(1) / 60;
  const Eigen::Matrix<Wide, 1, 6> D =
      -(Wide(mode.k) * predict.row(0) + Wide(mode.c) * predict.row(1)) / 2 - predict.row(2);
  return predict + correct * D;
}

/// Of (x, u, a): x += u + a/2, then a_new = -k x - c (u + a), u += (a + a_new)/2.
Map<3> verlet_map(const Mode& mode) {
  Map<3> map;
  map.row(0) << 1, 1, Wide(1) / 2;
  map.row(2) = -Wide(mode.k) * map.row(0);
  map(2, 1) -= mode.c;
  map(2, 2) -= mode.c;
  map.row(1) = map.row(2) / 2;
  map(1, 1) += 1;
  map(1, 2) += Wide(1) / 2;
  return map;
}

/// 1 + M + M^2/2 + M^3/6 + M^4/24 for (x, u)' = M (x, u).
Map<2> rk4_map(const Mode& mode) {
  Map<2> M;
  M << 0, 1, -mode.k, -mode.c;
  const Map<2> one = Map<2>::Identity();
  return one + M * (one + M / 2 * (one + M / 3 * (one + M / 4)));
}

template <int n>
double spectral_radius(const Map<n>& map) {
  if (!map.allFinite()) return std::numeric_limits<double>::infinity();
  return static_cast<double>(Eigen::EigenSolver<Map<n>>(map, false).eigenvalues().cwiseAbs().maxCoeff());
}

/// Contact by contact, what the dashpots and springs are for a small motion, both in steps.
struct Tangent {
  Eigen::ArrayXd K, C, below, above;  ///< and 1/m of the beads below and above
};

Tangent tangent(const Column<double>& column, double dt) {
  const auto n = static_cast<Eigen::Index>(column.contacts());
  const auto [beta, gamma] = column.exponents;
  // m v^2/2 = K x^(2+beta)/(2+beta), for a mean bead at the wall.
  const double x = std::pow((2.0 + beta) * column.speed * column.speed / (2.0 * column.K_wall), 1.0 / (2.0 + beta));
  const double k = (1.0 + beta) * std::pow(x, beta) * dt * dt, c = std::pow(x, gamma) * dt;
  Tangent t{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto contact = static_cast<std::size_t>(i);
    t.K[i] = k * column.spring(contact);
    t.C[i] = c * column.dashpot(contact);
    t.below[i] = contact == 0 ? 0.0 : column.inverse_mass(contact - 1);
    t.above[i] = column.inverse_mass(contact);
  }
  return t;
}

constexpr Eigen::Index most_contacts = 64;
constexpr double most_growth = 1.05;
constexpr double rounding = 1e-9;

}  // namespace

double growth_per_step(Integrator integrator, const Mode& mode) {
  switch (integrator) {
    case Integrator::gear5: return spectral_radius<6>(gear5_map(mode));
    case Integrator::verlet: return spectral_radius<3>(verlet_map(mode));
    case Integrator::rk4: return spectral_radius<2>(rk4_map(mode));
    case Integrator::exact: break;
  }
  throw std::invalid_argument("growth_per_step: not an integrator of fixed step");
}

/// The overlaps obey x'' = -A (K x + C x'), A = tridiag(-1/m_(k-1), 1/m_(k-1) + 1/m_k, -1/m_k). With x = A sqrt(K) y the
/// undamped modes are the eigenvectors y of the symmetric sqrt(K) A sqrt(K), to eigenvalues k, and the mode's share of
/// the dashpots is c = k sum_i y_i^2 C_i/K_i.
Mode stiffest_mode(const Column<double>& column, double dt) {
  if (column.is_uniform() && column.exponents.linear() && column.K_wall == column.K) {
    const double lambda = 2.0 + 2.0 * std::cos(2.0 * std::numbers::pi / (2.0 * static_cast<double>(column.N) + 1.0));
    return {lambda * column.K * dt * dt, lambda * column.C * dt};
  }
  const Tangent t = tangent(column, dt);
  Eigen::Index stiffest = 0;
  (t.K * (t.below + t.above)).maxCoeff(&stiffest);
  const Eigen::Index n = std::min(t.K.size(), most_contacts);
  const Eigen::Index first = std::clamp(stiffest - n / 2, Eigen::Index{0}, t.K.size() - n);
  const Eigen::ArrayXd K = t.K.segment(first, n), C = t.C.segment(first, n);
  const Eigen::VectorXd diagonal = K * (t.below + t.above).segment(first, n);
  const Eigen::VectorXd beside = -(K.head(n - 1) * K.tail(n - 1)).sqrt() * t.above.segment(first, n - 1);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
  modes.computeFromTridiagonal(diagonal, beside);
  const double k = modes.eigenvalues()[n - 1];
  return {k, k * (modes.eigenvectors().col(n - 1).array().square() * C / K).sum()};
}

double predicted_growth(const Parameters& p) {
  const double radius = growth_per_step(p.integrator, stiffest_mode(reduced_column<double>(p), 1.0 / p.steps_per_tc));
  if (radius <= 1.0 + rounding && radius >= 1.0 - rounding) return 1.0;
  return std::pow(radius, static_cast<double>(p.N) * p.steps_per_tc);
}

bool is_stable(const Parameters& p) { return predicted_growth(p) <= most_growth; }

}  // namespace sigmasweep
