#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "contact/contact_law.hpp"
#include "solve/fixed_step/aligned_lanes.hpp"

namespace sigmasweep {

/// How forces accelerate overlaps: Eq. (2) for neighbours subtracted from one another. Beads of equal mass 1:
///     x_k'' = F_(k-1) - g_k F_k + F_(k+1),  g_0 = 1, g_k = 2.
template <bool Uneven>
struct ChainCoupling {
  explicit ChainCoupling(const Column<double>& column) : g(column.contacts()) {
    for (std::size_t k = 0; k < column.contacts(); ++k) g[k] = k == 0 ? 1.0 : 2.0;
  }
  struct View {
    const double* g;
    double acceleration(const double* F, std::size_t k) const {
      return F[static_cast<std::ptrdiff_t>(k) - 1] - g[k] * F[k] + F[k + 1];
    }
  };
  View view() const { return {g.data()}; }
  AlignedLanes g;
};
/// Beads of masses m_k, bead k-1 below contact k and bead k above it (1/m = 0 for the wall):
///     x_k'' = (F_(k-1) - F_k)/m_(k-1) + (F_(k+1) - F_k)/m_k.
template <>
struct ChainCoupling<true> {
  explicit ChainCoupling(const Column<double>& column) : below(column.contacts()), above(column.contacts()) {
    for (std::size_t k = 0; k < column.contacts(); ++k) {
      if (k > 0) below[k] = column.inverse_mass(k - 1);
      above[k] = column.inverse_mass(k);
    }
  }
  struct View {
    const double *below, *above;
    double acceleration(const double* F, std::size_t k) const {
      return below[k] * (F[static_cast<std::ptrdiff_t>(k) - 1] - F[k]) + above[k] * (F[k + 1] - F[k]);
    }
  };
  View view() const { return {below.data(), above.data()}; }
  AlignedLanes below, above;
};

/// The column's equation of motion for its overlaps x_k, k = 0 (the wall) to N-1, with u_k = x_k', coupled as above by
/// the forces F_k of a law `Force`. Time is counted in steps here, so there is no dt in a scheme.
/// The lanes beyond N have an overlap that no motion brings above 0, and so never a force.
/// Ground: on a plate the column starts at rest relative to it.
template <class Force, bool Uneven, class Ground = FixedWall>
struct Chain {
  static constexpr bool driven = Ground::moves;
  static constexpr bool one_by_one = true;  ///< F_k depends on x_k and u_k only

  Chain(const Column<double>& column, double dt, const Ground& ground = {})
      : contacts(column.contacts()),
        blocks(AlignedLanes::padded(contacts) / AlignedLanes::width),
        force(column.exponents),
        coupling(column),
        K(contacts),
        C(contacts),
        x(contacts, -std::numeric_limits<double>::max()),
        u(contacts),
        speed(column.speed * dt),
        dt_(dt),
        ground_(ground) {
    for (std::size_t k = 0; k < contacts; ++k) {
      K[k] = column.spring(k) * dt * dt;
      C[k] = column.dashpot(k) * dt;
      x[k] = -column.initial_gap(k);
    }
    if constexpr (!driven) u[0] = speed;
    if constexpr (driven && Uneven) coupling.below[0] = 1.0;  // for drive()
  }

  /// The time at the start of the next step, in steps since the plate's period began.
  void set_time(double steps) requires driven { now_ = steps; }

  /// The plate's load, `ahead` steps into the next one, as what comes from below in the acceleration of contact 0. To
  /// be called after forces().
  void drive(double* F, double ahead) const {
    if constexpr (driven) F[-1] = ground_.load((now_ + ahead) * dt_) * dt_ * dt_ + (Uneven ? F[0] : 0.0);
  }

  /// F for the given overlaps and rates.
  void forces(const double* overlap, const double* rate, double* F) const {
    const double* spring = K.data();
    const double* dashpot = C.data();
    const Force law = force;
#pragma GCC ivdep
    for (std::size_t k = 0, n = lanes(); k < n; ++k)
      F[k] = where_closed(law, spring[k], dashpot[k], overlap[k], rate[k]);
  }

  /// x'' at the start, where the plate's load acts from the first moment on.
  AlignedLanes first_acceleration() const requires driven {
    AlignedLanes F(contacts), a(contacts);
    forces(x.data(), u.data(), F.data());
    drive(F.data(), 0.0);
    const auto view = coupling.view();
    for (std::size_t k = 0; k < contacts; ++k) a[k] = view.acceleration(F.data(), k);
    return a;
  }

  /// F_k for overlap x and rate u.
  auto contact() const {
    return [law = force, spring = K.data(), dashpot = C.data()](std::size_t k, double overlap, double rate) {
      return where_closed(law, spring[k], dashpot[k], overlap, rate);
    };
  }

  std::size_t contacts, blocks;
  std::size_t components() const { return contacts; }                 // of x and u
  std::size_t lanes() const { return blocks * AlignedLanes::width; }  // whole vectors, and the compiler sees it
  Force force;
  ChainCoupling<Uneven> coupling;
  AlignedLanes K, C;
  AlignedLanes x, u;  ///< at the start
  double speed;

 private:
  double dt_, now_ = 0.0;
  Ground ground_;
};

}  // namespace sigmasweep
