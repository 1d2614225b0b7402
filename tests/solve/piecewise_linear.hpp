#pragma once

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "assembly/column.hpp"

/// A second method for columns of unequal beads, slow and simple: while the set of closed contacts stays the same
/// z = (x, u) obeys z' = M z, so z(t) = exp(M t) z(0) by Eigen's matrix exponential (Pade and squaring); steps much
/// shorter than any contact, and bisection for the moment a contact changes within one.
namespace sigmasweep::piecewise_linear {

using Scalar = long double;
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

struct Result {
  std::vector<double> velocity;  ///< of the beads, at the end
  double dashpot_work = 0.0;     ///< int sum C u^2 dt, by Gauss's quadrature
  int contacts = 0;
};

class Solver {
 public:
  /// `step` must be short against the fastest motion. Work of the dashpots only if asked: it is slow.
  Solver(const Column<double>& column, double step, bool work = false)
      : column_(column),
        n_(column.N),
        step_(step),
        work_(work),
        closed_(std::size_t(n_), false),
        z_(Vector::Zero(2 * n_)) {
    for (Eigen::Index k = 1; k < n_; ++k) z_(k) = -Scalar(column.initial_gap(std::size_t(k)));
    z_(n_) = column.speed;
    for (Eigen::Index k = 0; k < n_; ++k) closed_[std::size_t(k)] = z_(k) == 0;
    build();
  }

  Result run() {
    while (!finished()) advance();
    Scalar sum = 0;
    for (Eigen::Index k = 0; k < n_; ++k) result_.velocity.push_back(double(sum -= z_(n_ + k)));
    return result_;
  }

 private:
  bool is_closed(Eigen::Index k) const { return closed_[std::size_t(k)]; }
  bool any_closed() const {
    for (Eigen::Index k = 0; k < n_; ++k)
      if (is_closed(k)) return true;
    return false;
  }
  /// Also when beads stick together for good, at rest to one another.
  bool finished() const {
    const Scalar still = 1e-14;
    for (Eigen::Index k = 0; k < n_; ++k)
      if (is_closed(k) ? std::abs(z_(k)) > still || std::abs(z_(n_ + k)) > still : z_(n_ + k) > still) return false;
    return true;
  }

  Scalar inverse_mass(Eigen::Index bead) const {
    return column_.mass.empty() ? 1 : 1 / Scalar(column_.mass[std::size_t(bead)]);
  }
  Scalar reduced(Eigen::Index k) const { return 1 / (inverse_mass(k) + (k > 0 ? inverse_mass(k - 1) : 0)); }
  Scalar spring(Eigen::Index k) const { return k == 0 ? column_.K_wall : column_.K; }
  /// D_n m_ij, m_ij = 2 m_red; at the wall D_n m.
  Scalar dashpot(Eigen::Index k) const { return k == 0 ? column_.C_wall * reduced(0) : 2 * column_.C * reduced(k); }

  /// Bead i, between contacts i and i+1, is accelerated by (F_i - F_(i+1))/m_i; x_k' = v_(k-1) - v_k.
  void build() {
    Matrix acceleration = Matrix::Zero(n_, 2 * n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      if (!is_closed(k)) continue;
      acceleration(k, k) += inverse_mass(k) * spring(k);
      acceleration(k, n_ + k) += inverse_mass(k) * dashpot(k);
      if (k == 0) continue;
      acceleration(k - 1, k) -= inverse_mass(k - 1) * spring(k);
      acceleration(k - 1, n_ + k) -= inverse_mass(k - 1) * dashpot(k);
    }
    M_ = Matrix::Zero(2 * n_, 2 * n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      M_(k, n_ + k) = 1;
      M_.row(n_ + k) = -acceleration.row(k);
      if (k > 0) M_.row(n_ + k) += acceleration.row(k - 1);
    }
    whole_step_ = flow(step_);
  }
  Matrix flow(Scalar t) const { return Matrix(M_ * t).exp(); }

  /// Which contact has changed its side of 0 in z; -1: none.
  Eigen::Index changed(const Vector& z) const {
    for (Eigen::Index k = 0; k < n_; ++k)
      if (is_closed(k) ? z(k) < 0 : z(k) > 0) return k;
    return -1;
  }

  void advance() {
    if (!any_closed()) {
      Scalar t = std::numeric_limits<Scalar>::infinity();
      for (Eigen::Index k = 0; k < n_; ++k)
        if (z_(n_ + k) > 0) t = std::min(t, -z_(k) / z_(n_ + k));
      if (t > step_) z_.head(n_) += (t - step_ / 2) * z_.tail(n_);
    }
    const Vector next = whole_step_ * z_;
    Eigen::Index k = changed(next);
    if (k < 0) {
      add_work(step_);
      z_ = next;
      return;
    }
    Scalar before = 0, after = step_;
    while (after - before > 1e-18L * step_) {
      const Scalar middle = (before + after) / 2;
      if (middle == before || middle == after) break;
      const Eigen::Index there = changed(flow(middle) * z_);
      (there < 0 ? before : after) = middle;
      if (there >= 0) k = there;
    }
    add_work(after);
    z_ = flow(after) * z_;
    z_(k) = 0;
    result_.contacts += is_closed(k);
    closed_[std::size_t(k)] = !is_closed(k);
    build();
  }

  void add_work(Scalar duration) {
    if (!work_) return;
    const auto power = [&](Scalar t) {
      const Vector z = flow(t) * z_;
      Scalar sum = 0;
      for (Eigen::Index k = 0; k < n_; ++k)
        if (is_closed(k)) sum += dashpot(k) * z(n_ + k) * z(n_ + k);
      return sum;
    };
    result_.dashpot_work += double(boost::math::quadrature::gauss<Scalar, 7>::integrate(power, Scalar(0), duration));
  }

  const Column<double>& column_;
  Eigen::Index n_;
  Scalar step_;
  bool work_;
  std::vector<bool> closed_;
  Vector z_;
  Matrix M_, whole_step_;
  Result result_;
};

}  // namespace sigmasweep::piecewise_linear
