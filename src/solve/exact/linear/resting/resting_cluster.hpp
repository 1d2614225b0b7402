#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"

namespace sigmasweep {

/// The lowest n beads of a column under the linear law while they lie on the plate, all of their contacts 0..n-1
/// closed. Then x'' + T (C x' + K x) = load(t) e_0, T = tridiag(-1/m_(k-1), 1/m_(k-1) + 1/m_k, -1/m_k), and the
/// overlaps are
///     x(t) = x_static + Im(w e^(i omega t)) + sum_j V_j c_j e^(lambda_j t):
/// the answer to load(t), and the 2n modes, which die out. Closed formulas for any time, however many contact times
/// away, and bounds that say how long no contact can open. Above the cluster is the open gap n, if n < N, into which it
/// pushes: x_n'' = F_(n-1)/m_(n-1). See docs/physics/exact-linear.md.
class RestingCluster {
 public:
  RestingCluster(const Column<double>& column, const Plate& plate, std::size_t n);

  /// Where it is at time t: overlaps and rates of contacts 0..n-1 and, if there is one, of gap n. False where the modes
  /// cannot tell (two of them almost the same, as in contacts damped critically).
  bool start(std::span<const double> x, std::span<const double> u, double t);

  /// For how long from the start on certainly nothing opens or closes; not longer than `longest`, nor much shorter than
  /// it could be, but for what is below `shortest`.
  double undisturbed(double longest, double shortest) const;

  /// The largest overlap up to `elapsed` after the start; while it rings, within what is seen four times a contact
  /// time.
  double deepest(double elapsed) const;

  /// x and u at `elapsed` after the start.
  void evaluate(double elapsed, std::span<double> x, std::span<double> u) const;

  /// The plate's work from the start to `elapsed` later, and what the contacts lost.
  PlateWork work(double elapsed) const;

 private:
  using Complex = std::complex<double>;

  Complex& mode(std::size_t row, std::size_t j) { return modes_[row * 2 * n_ + j]; }
  const Complex& mode(std::size_t row, std::size_t j) const { return modes_[row * 2 * n_ + j]; }
  bool holds(double from, double to) const;
  double quasi_static(std::size_t k, double phase) const;
  double extreme_quasi_static(std::size_t k, double from, double to, int side) const;
  double forced(std::size_t k) const { return std::abs(w_[k]); }

  Plate plate_;
  std::size_t n_;
  bool has_gap_, is_sound_ = false;
  double below_ = 0.0;  ///< 1/m of the bead below gap n
  std::vector<double> K_, C_;
  std::vector<double> x_static_;
  std::vector<Complex> w_;        ///< answer to the plate's sine
  std::vector<Complex> lambda_;   ///< 2n rates
  std::vector<Complex> modes_;    ///< V: rows are x_0..x_(n-1), u_0..u_(n-1)
  std::vector<Complex> inverse_;  ///< V^-1

  double t_ = 0.0;          ///< of the start
  std::vector<Complex> c_;  ///< amplitudes of the modes
  double x_gap_ = 0.0, u_gap_ = 0.0;
};

}  // namespace sigmasweep
