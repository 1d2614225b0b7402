#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "sigmasweep/model/row.hpp"
#include "sigmasweep/model/trajectory.hpp"

/// The motion of a row's beads as viewers of molecular dynamics show it: spheres in space, and the forces between them.
namespace sigmasweep {

using Vec3 = std::array<double, 3>;

/// A closed contact of bead i with bead j, or with a wall.
struct FilmContact {
  static constexpr std::size_t wall = SIZE_MAX;
  std::size_t i = 0, j = wall;
  double overlap = 0.0;  ///< m
  Vec3 force{};          ///< on bead i, over the mean bead's mass, m/s^2
};

/// Axes are x to the right, z upwards; y is 0. Beads are numbered from 0, the lowest one.
class Film {
 public:
  Film(const Tuple& tuple, Trajectory trajectory);

  std::uint64_t row() const { return tuple_.index; }
  std::size_t beads() const { return trajectory_.beads(); }
  /// Number of samples before the solver gave up, if it did.
  std::size_t samples() const { return samples_; }
  double time(std::size_t sample) const { return trajectory_.time[sample]; }  ///< s
  /// Of the centre, m.
  Vec3 position(std::size_t sample, std::size_t bead) const;
  Vec3 velocity(std::size_t sample, std::size_t bead) const;                        ///< m/s
  double radius(std::size_t bead) const { return trajectory_.diameter[bead] / 2; }  ///< m
  double mass(std::size_t bead) const { return trajectory_.mass[bead]; }            ///< over the mean bead's

  bool has_forces() const {
    return tuple_.parameters.method == Method::md;
  }  ///< collisions of hard spheres take no time
  /// The closed contacts of a sample, of the law of Eq. (8) with the dashpots of Eqs. (3) and (4).
  std::vector<FilmContact> contacts(std::size_t sample) const;
  /// The sum of the forces of these contacts on each bead, over the mean bead's mass, m/s^2. Without gravity.
  std::vector<Vec3> forces(std::span<const FilmContact> contacts) const;

  /// The corners of a box around all positions at all times, m.
  std::array<Vec3, 2> box() const { return box_; }
  bool is_periodic() const { return trajectory_.periodic; }  ///< in x

 private:
  Tuple tuple_;
  Trajectory trajectory_;
  Column<double> laws_;  ///< in SI units; of soft spheres
  std::size_t samples_;
  std::array<Vec3, 2> box_;
};

}  // namespace sigmasweep
