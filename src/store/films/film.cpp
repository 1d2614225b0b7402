#include "store/films/film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "store/films/film_contacts.hpp"

namespace sigmasweep {
namespace {

std::array<Vec3, 2> box_around(const Trajectory& t) {
  const double largest = std::ranges::max(t.diameter), infinity = std::numeric_limits<double>::infinity();
  double left = infinity, right = -infinity, top = 0.0, bottom = 0.0;
  for (std::size_t k = 0; k < t.z.size(); ++k) {
    const std::size_t bead = k % t.beads();
    const double r = t.diameter[bead] / 2, x = t.is_plane() ? t.x[k] : 0.0, z = t.z[k] + t.base(bead);
    if (!std::isfinite(x + z)) continue;
    left = std::min(left, x - r);
    right = std::max(right, x + r);
    bottom = std::min(bottom, z - r);
    top = std::max(top, z + r);
  }
  if (t.is_plane() && t.box_width > 0.0) std::tie(left, right) = std::pair(0.0, t.box_width);
  if (!(left < right)) std::tie(left, right) = std::pair(-largest / 2, largest / 2);
  return {Vec3{left, -largest / 2, bottom}, Vec3{right, largest / 2, std::max(top, bottom + largest)}};
}

std::size_t known_samples(const Trajectory& t) {
  const auto unknown = std::ranges::find_if_not(t.z, [](double z) { return std::isfinite(z); });
  return static_cast<std::size_t>(unknown - t.z.begin()) / t.beads();
}

}  // namespace

Film::Film(const Tuple& tuple, Trajectory trajectory)
    : tuple_(tuple),
      trajectory_(std::move(trajectory)),
      laws_(has_forces() ? si_column<double>(tuple.parameters) : Column<double>{}),
      samples_(known_samples(trajectory_)),
      box_(box_around(trajectory_)) {}

Vec3 Film::position(std::size_t sample, std::size_t bead) const {
  const std::size_t k = sample * beads() + bead;
  return {trajectory_.is_plane() ? trajectory_.x[k] : 0.0, 0.0, trajectory_.z[k] + trajectory_.base(bead)};
}

Vec3 Film::velocity(std::size_t sample, std::size_t bead) const {
  const std::size_t k = sample * beads() + bead;
  return {trajectory_.is_plane() ? trajectory_.x_velocity[k] : 0.0, 0.0, trajectory_.velocity[k]};
}

std::vector<FilmContact> Film::contacts(std::size_t sample) const {
  if (!has_forces()) return {};
  return trajectory_.is_plane() ? lattice_contacts(tuple_.parameters, laws_, trajectory_, sample)
                                : column_contacts(tuple_.parameters, laws_, trajectory_, sample);
}

std::vector<Vec3> Film::forces(std::span<const FilmContact> contacts) const {
  std::vector<Vec3> sum(beads());
  for (const FilmContact& contact : contacts)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[contact.i][axis] += contact.force[axis];
      if (contact.j != FilmContact::wall) sum[contact.j][axis] -= contact.force[axis];
    }
  return sum;
}

}  // namespace sigmasweep
