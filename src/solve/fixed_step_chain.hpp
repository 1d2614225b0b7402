#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "sigmasweep/solve/column.hpp"

namespace sigmasweep {

/// One number a contact, padded to whole vectors of the machine, with room on either side for a stencil.
class Lanes {
 public:
  static constexpr std::size_t width = 4;
  static constexpr std::size_t padded(std::size_t contacts) { return (contacts + width - 1) / width * width; }
  explicit Lanes(std::size_t contacts, double value = 0.0) : data_(padded(contacts) + 2 * width, value) {}
  double* data() { return data_.data() + width; }
  const double* data() const { return data_.data() + width; }
  double& operator[](std::size_t k) { return data()[k]; }
  double operator[](std::size_t k) const { return data()[k]; }

 private:
  std::vector<double> data_;
};

/// The column's equation of motion for its overlaps x_k, k = 0 (the wall) to N-1, with u_k = x_k':
///     x_k'' = F_(k-1) - g_k F_k + F_(k+1),  F_k = K_k x_k + C_k u_k where x_k > 0, else 0,  g_0 = 1, g_k = 2,
/// Eq. (2) for neighbours subtracted from one another. Time is counted in steps here, so there is no dt in a scheme.
/// The lanes beyond N have an overlap that no motion brings above 0, and so never a force.
struct Chain {
  Chain(const Column<double>& column, double dt);

  /// F for the given overlaps and rates. The loops over contacts vectorise: a contact's being closed is a mask.
  void forces(const double* overlap, const double* rate, double* F) const {
    const double* spring = K.data();
    const double* dashpot = C.data();
#pragma GCC ivdep
    for (std::size_t k = 0, n = lanes(); k < n; ++k)
      F[k] = overlap[k] > 0.0 ? spring[k] * overlap[k] + dashpot[k] * rate[k] : 0.0;
  }
  static double acceleration(const double* F, const double* inertia, std::size_t k) {
    return F[static_cast<std::ptrdiff_t>(k) - 1] - inertia[k] * F[k] + F[k + 1];
  }

  std::size_t contacts, blocks;
  std::size_t lanes() const { return blocks * Lanes::width; }  // whole vectors, and the compiler sees it
  Lanes K, C, g;
  Lanes x, u;  ///< at the start
};

}  // namespace sigmasweep
