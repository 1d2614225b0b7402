#include "solve/exact/linear/resting/resting_cluster.hpp"

#include <algorithm>
#include <cmath>

#include "solve/exact/linear/resting/general_modes.hpp"
#include "solve/exact/linear/resting/proportional_modes.hpp"

namespace sigmasweep {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0.0, 1.0};
/// Modes are trusted if they give the start back to this, relative to it.
constexpr double sound = 1e-12;

Eigen::MatrixXd coupling(const Column<double>& column, std::size_t n) {
  const auto size = Eigen::Index(n);
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    T(k, k) = column.inertia(std::size_t(k));
    if (k > 0) T(k, k - 1) = T(k - 1, k) = -column.inverse_mass(std::size_t(k) - 1);
  }
  return T;
}

/// sum_n z^n first!/(n + first)!, which is (e^z - 1)/z for first = 1; |z| < 1.
Complex series(const Complex& z, int first) {
  Complex sum = 1.0, term = 1.0;
  for (int n = first + 1; std::abs(term) > 1e-17; ++n) sum += term *= z / double(n);
  return sum;
}

/// (e^(s t) - 1)/s
Complex integral(const Complex& s, double t) {
  const Complex st = s * t;
  return std::abs(st) < 0.5 ? t * series(st, 1) : (std::exp(st) - 1.0) / s;
}

/// (e^(s t) - 1 - s t)/s^2
Complex second_integral(const Complex& s, double t) {
  const Complex st = s * t;
  return std::abs(st) < 0.5 ? 0.5 * t * t * series(st, 2) : (std::exp(st) - 1.0 - st) / (s * s);
}

}  // namespace

RestingCluster::RestingCluster(const Column<double>& column, const Plate& plate, std::size_t n)
    : plate_(plate), n_(n), has_gap_(n < column.contacts()), below_(column.inverse_mass(n - 1)), c_(2 * n) {
  const auto size = Eigen::Index(n);
  const Eigen::MatrixXd T = coupling(column, n);
  Eigen::VectorXd K(size), C(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    K_.push_back(K[k] = column.spring(std::size_t(k)));
    C_.push_back(C[k] = column.dashpot(std::size_t(k)));
  }
  const Eigen::MatrixXd TK = T * K.asDiagonal(), TC = T * C.asDiagonal();
  const Eigen::VectorXd first = Eigen::VectorXd::Unit(size, 0);

  const Eigen::VectorXd x_static = TK.fullPivLu().solve(plate.g * first);
  x_static_.assign(x_static.begin(), x_static.end());
  const double omega = plate.omega, drive = -plate.A0 * omega * omega;
  const Eigen::MatrixXcd response =
      TK.cast<Complex>() + i * omega * TC.cast<Complex>() - omega * omega * Eigen::MatrixXcd::Identity(size, size);
  const Eigen::VectorXcd w = response.fullPivLu().solve(drive * first.cast<Complex>());
  w_.assign(w.begin(), w.end());

  const bool proportional = (C * K[0] - K * C[0]).cwiseAbs().maxCoeff() <= 1e-15 * C[0] * K.maxCoeff();
  const Modes modes = proportional ? proportional_modes(T, K, C[0] / K[0]) : general_modes(TK, TC);
  for (const Complex& rate : modes.lambda) lambda_.emplace_back(std::min(rate.real(), 0.0), rate.imag());
  modes_.resize(4 * n * n);
  inverse_.resize(4 * n * n);
  for (Eigen::Index row = 0; row < 2 * size; ++row)
    for (Eigen::Index j = 0; j < 2 * size; ++j) {
      mode(std::size_t(row), std::size_t(j)) = modes.V(row, j);
      inverse_[std::size_t(row * 2 * size + j)] = modes.inverse(row, j);
    }
  is_sound_ = modes.V.allFinite() && modes.inverse.allFinite();
}

bool RestingCluster::start(std::span<const double> x, std::span<const double> u, double t) {
  if (!is_sound_) return false;
  t_ = t;
  if (has_gap_) {
    x_gap_ = x[n_];
    u_gap_ = u[n_];
  }
  const Complex turned = std::exp(i * (plate_.omega * t));
  std::vector<double> y(2 * n_);
  double size = 0.0;
  for (std::size_t k = 0; k < n_; ++k) {
    y[k] = x[k] - x_static_[k] - std::imag(w_[k] * turned);
    y[n_ + k] = u[k] - std::imag(i * plate_.omega * w_[k] * turned);
    size = std::max({size, std::fabs(y[k]), std::fabs(y[n_ + k])});
  }
  for (std::size_t j = 0; j < 2 * n_; ++j) {
    Complex sum = 0.0;
    for (std::size_t row = 0; row < 2 * n_; ++row) sum += inverse_[j * 2 * n_ + row] * y[row];
    c_[j] = sum;
  }
  for (std::size_t row = 0; row < 2 * n_; ++row) {
    Complex sum = 0.0;
    for (std::size_t j = 0; j < 2 * n_; ++j) sum += mode(row, j) * c_[j];
    if (!(std::abs(sum - y[row]) <= sound * size)) return false;
  }
  return true;
}

double RestingCluster::quasi_static(std::size_t k, double phase) const {
  return x_static_[k] + std::imag(w_[k] * std::exp(i * phase));
}

/// The least (side = -1) or largest (side = 1) x_static + |w| sin(phase + arg w) between two phases.
double RestingCluster::extreme_quasi_static(std::size_t k, double from, double to, int side) const {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double shift = std::arg(w_[k]) - side * 0.5 * std::numbers::pi;  // there at phase + shift = multiples of a turn
  if (std::floor((from + shift) / turn) != std::floor((to + shift) / turn)) return x_static_[k] + side * forced(k);
  const auto [least, largest] = std::minmax({quasi_static(k, from), quasi_static(k, to)});
  return side < 0 ? least : largest;
}

/// Without the ringing in closed form; with it, at the start, where it is looked at.
double RestingCluster::deepest(double elapsed) const {
  constexpr double often = 0.25;  // of t_c, the unit of time
  constexpr int looks = 64;
  double largest = 0.0;
  std::vector<double> x(n_ + 1), u(n_ + 1);
  for (int look = 0; look <= looks && often * look <= elapsed; ++look) {
    evaluate(often * look, x, u);
    largest = std::max(largest, *std::max_element(x.begin(), x.begin() + std::ptrdiff_t(n_)));
  }
  if (often * looks >= elapsed) return largest;
  const double first = plate_.omega * (t_ + often * looks), last = plate_.omega * (t_ + elapsed);
  for (std::size_t k = 0; k < n_; ++k) largest = std::max(largest, extreme_quasi_static(k, first, last, 1));
  return largest;
}

/// Whether nothing can happen from `from` to `to` after the start. The modes that are left at `from` only get smaller.
bool RestingCluster::holds(double from, double to) const {
  std::vector<double> left(2 * n_);
  for (std::size_t j = 0; j < 2 * n_; ++j) left[j] = std::abs(c_[j]) * std::exp(lambda_[j].real() * from);
  const auto ringing = [&](std::size_t row) {
    double sum = 0.0;
    for (std::size_t j = 0; j < 2 * n_; ++j) sum += std::abs(mode(row, j)) * left[j];
    return sum;
  };
  const double first = plate_.omega * (t_ + from), last = plate_.omega * (t_ + to);
  for (std::size_t k = n_; k-- > 0;)
    if (!(extreme_quasi_static(k, first, last, -1) > ringing(k))) return false;
  if (!has_gap_) return true;
  std::vector<double> x(n_ + 1), u(n_ + 1);
  evaluate(from, x, u);
  const std::size_t top = n_ - 1;
  const double force = K_[top] * (x_static_[top] + forced(top) + ringing(top)) +
                       C_[top] * (plate_.omega * forced(top) + ringing(n_ + top));
  const double wait = to - from;
  return x[n_] + std::max(u[n_], 0.0) * wait + 0.5 * below_ * force * wait * wait < 0.0;
}

double RestingCluster::undisturbed(double longest, double shortest) const {
  double sure = 0.0;
  for (double width = longest; width >= shortest && sure < longest;) {
    const double next = std::min(longest, sure + width);
    if (holds(sure, next)) {
      sure = next;
      width *= 2.0;
    } else {
      width *= 0.25;
    }
  }
  return sure;
}

void RestingCluster::evaluate(double elapsed, std::span<double> x, std::span<double> u) const {
  const Complex began = std::exp(i * (plate_.omega * t_)), turned = began * std::exp(i * (plate_.omega * elapsed));
  std::vector<Complex> now(2 * n_);
  for (std::size_t j = 0; j < 2 * n_; ++j) now[j] = c_[j] * std::exp(lambda_[j] * elapsed);
  for (std::size_t k = 0; k < n_; ++k) {
    double ringing = 0.0, rate = 0.0;
    for (std::size_t j = 0; j < 2 * n_; ++j) {
      ringing += (mode(k, j) * now[j]).real();
      rate += (mode(n_ + k, j) * now[j]).real();
    }
    x[k] = x_static_[k] + std::imag(w_[k] * turned) + ringing;
    u[k] = std::imag(i * plate_.omega * w_[k] * turned) + rate;
  }
  if (!has_gap_) return;
  const std::size_t top = n_ - 1;
  const Complex sine = (K_[top] + i * plate_.omega * C_[top]) * w_[top] * began, rate = i * plate_.omega;
  double push = K_[top] * x_static_[top] * elapsed + std::imag(sine * integral(rate, elapsed));
  double shift = 0.5 * K_[top] * x_static_[top] * elapsed * elapsed + std::imag(sine * second_integral(rate, elapsed));
  for (std::size_t j = 0; j < 2 * n_; ++j) {
    const Complex force = (K_[top] * mode(top, j) + C_[top] * mode(n_ + top, j)) * c_[j];
    push += (force * integral(lambda_[j], elapsed)).real();
    shift += (force * second_integral(lambda_[j], elapsed)).real();
  }
  x[n_] = x_gap_ + u_gap_ * elapsed + below_ * shift;
  u[n_] = u_gap_ + below_ * push;
}

/// Sums of exponentials, integrated term by term: int F_0 z0' dt and sum_k int C_k u_k^2 dt.
PlateWork RestingCluster::work(double elapsed) const {
  const std::size_t terms = 2 * n_ + 2;  // the modes, and the plate's sine as two
  const Complex began = std::exp(i * (plate_.omega * t_)), turn = i * plate_.omega;
  std::vector<Complex> rate = lambda_;
  rate.push_back(turn);
  rate.push_back(-turn);
  const auto sine = [&](const Complex& amplitude, std::size_t m) {  // Im(amplitude e^(i omega t)) in two terms
    const Complex z = amplitude * began / (2.0 * i);
    return m == 2 * n_ ? z : std::conj(z);
  };
  const auto x_term = [&](std::size_t k, std::size_t m) { return m < 2 * n_ ? mode(k, m) * c_[m] : sine(w_[k], m); };
  const auto u_term = [&](std::size_t k, std::size_t m) {
    return m < 2 * n_ ? mode(n_ + k, m) * c_[m] : sine(turn * w_[k], m);
  };

  Complex in = 0.0;
  const Complex speed = 0.5 * plate_.A0 * plate_.omega * began;  // of e^(i omega t); the other one is its conjugate
  for (std::size_t m = 0; m <= terms; ++m) {
    const bool is_static = m == terms;
    const Complex force = is_static ? Complex(K_[0] * x_static_[0]) : K_[0] * x_term(0, m) + C_[0] * u_term(0, m);
    const Complex s = is_static ? Complex(0.0) : rate[m];
    in += force * (speed * integral(s + turn, elapsed) + std::conj(speed) * integral(s - turn, elapsed));
  }
  std::vector<Complex> u(n_ * terms);
  for (std::size_t k = 0; k < n_; ++k)
    for (std::size_t m = 0; m < terms; ++m) u[k * terms + m] = std::sqrt(C_[k]) * u_term(k, m);
  Complex lost = 0.0;
  for (std::size_t m = 0; m < terms; ++m)
    for (std::size_t l = m; l < terms; ++l) {
      Complex product = 0.0;
      for (std::size_t k = 0; k < n_; ++k) product += u[k * terms + m] * u[k * terms + l];
      lost += (l == m ? 1.0 : 2.0) * product * integral(rate[m] + rate[l], elapsed);
    }
  return {in.real(), lost.real()};
}

}  // namespace sigmasweep
