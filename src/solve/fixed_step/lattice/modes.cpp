#include "solve/fixed_step/lattice/modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <tuple>

#include "base/random.hpp"

namespace sigmasweep {
namespace {

constexpr std::int64_t max_beads = 40;  // rows or columns; larger lattices change eigenvalues by less than 0.2 %
constexpr int iterations = 200;
constexpr std::array<ModalCoefficients, 4> weights{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}}};

/// A contact of two beads on their sites, or of a bead and a wall.
struct Contact {
  std::size_t i, j;  ///< j == i: a wall
  Vec2<double> n;
  ModalCoefficients of;  ///< spring and dashpots of the contact
};

class ClosedLattice {
 public:
  explicit ClosedLattice(const Lattice<double>& lattice)
      : lattice_(lattice), rows_(std::min(lattice.rows, max_beads)), columns_(std::min(lattice.columns, max_beads)) {
    for (std::int64_t row = 0; row < rows_; ++row)
      for (std::int64_t place = 0; place < columns_; ++place) {
        inverse_root_.push_back(1.0 / std::sqrt(mass(row, place)));
        add_contacts(row, place);
      }
  }

  /// Coefficients of the motion with the largest weighted sum, by power iteration.
  ModalCoefficients largest(const ModalCoefficients& weight) const {
    std::vector<Vec2<double>> y;
    for (std::uint64_t i = 0; i < inverse_root_.size(); ++i)
      y.push_back({unit_interval(random_bits(1, 2 * i)) - 0.5, unit_interval(random_bits(1, 2 * i + 1)) - 0.5});
    for (int k = 0; k < iterations; ++k) y = normalised(forces(y, weight));
    return shares(y);
  }

 private:
  double mass(std::int64_t row, std::int64_t place) const {
    return lattice_.mass(static_cast<std::size_t>(row * lattice_.columns + place));
  }

  /// Adds the contacts of a bead with beads to the right and above, and with walls.
  void add_contacts(std::int64_t row, std::int64_t place) {
    constexpr double half = 0.5, up = std::numbers::sqrt3 / 2;
    const std::int64_t odd = row % 2;
    add(row, place, row, place + 1, {1, 0});
    if (row + 1 < rows_) {
      add(row, place, row + 1, place + odd, {half, up});
      add(row, place, row + 1, place + odd - 1, {-half, up});
    }
    if (row == 0) add_wall(row, place, {0, 1});
    if (!lattice_.periodic && place == (odd ? columns_ - 1 : 0)) add_wall(row, place, {1, 0});
  }
  void add(std::int64_t row, std::int64_t place, std::int64_t other_row, std::int64_t other, const Vec2<double>& n) {
    if (!lattice_.periodic && (other < 0 || other >= columns_)) return;
    other = (other + columns_) % columns_;
    if (row == other_row && place == other) return;  // its own image
    const double m = mass(row, place), M = mass(other_row, other), m_ij = 2.0 * m * M / (m + M);
    contacts_.push_back({number(row, place), number(other_row, other), n, {1.0, m_ij, m_ij}});
  }
  void add_wall(std::int64_t row, std::int64_t place, const Vec2<double>& n) {
    const Column<double>& beads = lattice_.beads;
    const double m = mass(row, place), spring = beads.K_wall / beads.K;
    const double dashpot = beads.C > 0.0 ? beads.C_wall / beads.C : spring;
    contacts_.push_back({number(row, place), number(row, place), n, {spring, m * dashpot, m}});
  }
  std::size_t number(std::int64_t row, std::int64_t place) const {
    return static_cast<std::size_t>(row * columns_ + place);
  }

  /// Relative displacement in a contact. y is displacement times the root of the mass, so that the matrix is symmetric.
  Vec2<double> relative(const Contact& c, const std::vector<Vec2<double>>& y) const {
    const Vec2<double> x = inverse_root_[c.i] * y[c.i];
    return c.j == c.i ? x : x - inverse_root_[c.j] * y[c.j];
  }
  std::vector<Vec2<double>> forces(const std::vector<Vec2<double>>& y, const ModalCoefficients& weight) const {
    std::vector<Vec2<double>> sum(y.size());
    for (const Contact& c : contacts_) {
      const Vec2<double> w = relative(c, y);
      const double along = dot(c.n, w), friction = weight.friction * c.of.friction;
      const double normal = weight.spring * c.of.spring + weight.dashpot * c.of.dashpot;
      const Vec2<double> F = friction * w + ((normal - friction) * along) * c.n;
      sum[c.i] += inverse_root_[c.i] * F;
      if (c.j != c.i) sum[c.j] -= inverse_root_[c.j] * F;
    }
    return sum;
  }
  ModalCoefficients shares(const std::vector<Vec2<double>>& y) const {
    ModalCoefficients sum;
    for (const Contact& c : contacts_) {
      const Vec2<double> w = relative(c, y);
      const double along = dot(c.n, w) * dot(c.n, w), across = dot(w, w) - along;
      sum.spring += c.of.spring * along;
      sum.dashpot += c.of.dashpot * along;
      sum.friction += c.of.friction * across;
    }
    return sum;
  }
  static std::vector<Vec2<double>> normalised(std::vector<Vec2<double>> y) {
    double squares = 0.0;
    for (const Vec2<double>& each : y) squares += dot(each, each);
    for (Vec2<double>& each : y) each = 1.0 / std::sqrt(squares) * each;
    return y;
  }

  const Lattice<double>& lattice_;
  std::int64_t rows_, columns_;
  std::vector<double> inverse_root_;  ///< 1/sqrt(mass)
  std::vector<Contact> contacts_;
};

std::vector<ModalCoefficients> found(const Lattice<double>& lattice) {
  const ClosedLattice closed(lattice);
  std::vector<ModalCoefficients> shares;
  for (const ModalCoefficients& weight : weights) shares.push_back(closed.largest(weight));
  return shares;
}

}  // namespace

/// Results for equal beads are kept, because they take milliseconds, and a sweep uses the same few lattices many times.
std::vector<ModalCoefficients> largest_shares(const Lattice<double>& lattice) {
  if (!lattice.beads.is_uniform()) return found(lattice);
  constexpr std::size_t most = 256;
  thread_local std::map<std::tuple<std::int64_t, std::int64_t, bool, double>, std::vector<ModalCoefficients>> known;
  const std::tuple key(lattice.rows, lattice.columns, lattice.periodic, lattice.beads.K_wall / lattice.beads.K);
  if (const auto before = known.find(key); before != known.end()) return before->second;
  if (known.size() >= most) known.clear();
  return known[key] = found(lattice);
}

}  // namespace sigmasweep
