#include "store/films/film_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "assembly/ground.hpp"
#include "base/vec2.hpp"
#include "contact/contact_law.hpp"
#include "sigmasweep/model/relevance.hpp"

namespace sigmasweep {
namespace {

using Vec = Vec2<double>;

bool vibrates(const Parameters& p) { return applies_to(*find_field("frequency"), p); }

/// The plate's height and speed; a wall is at rest.
struct Bottom {
  double height = 0.0, speed = 0.0;
};
Bottom bottom_at(const Parameters& p, double time) {
  if (!vibrates(p)) return {};
  return {plate_height(p, time), plate_speed(p, time)};
}

/// Discs of a lattice at one time.
class Discs {
 public:
  Discs(const Parameters& p, const Column<double>& contact_laws, const Trajectory& motion, std::size_t sample)
      : p_(p), laws_(contact_laws), motion_(motion), first_(sample * motion.beads()) {}

  std::vector<FilmContact> contacts() {
    const Bottom bottom = bottom_at(p_, motion_.time[first_ / motion_.beads()]);
    for (std::size_t i = 0; i < motion_.beads(); ++i) {
      if (!std::isfinite(place(i).x + place(i).z)) continue;
      touch_wall(i, {0.0, 1.0}, place(i).z - bottom.height, {0.0, bottom.speed});
      if (motion_.periodic) continue;
      touch_wall(i, {1.0, 0.0}, place(i).x, {});
      touch_wall(i, {-1.0, 0.0}, motion_.box_width - place(i).x, {});
    }
    for (const auto& [i, j] : near()) touch(i, j);
    return std::move(found_);
  }

 private:
  Vec place(std::size_t i) const { return {motion_.x[first_ + i], motion_.z[first_ + i]}; }
  Vec speed(std::size_t i) const { return {motion_.x_velocity[first_ + i], motion_.velocity[first_ + i]}; }
  double radius(std::size_t i) const { return motion_.diameter[i] / 2; }

  /// Pairs that may touch: those in the same or in neighbouring cells of a grid. In a periodic container the grid is.
  std::vector<std::pair<std::size_t, std::size_t>> near() const {
    const double cell = std::ranges::max(motion_.diameter);
    const auto columns = std::max<std::int64_t>(1, static_cast<std::int64_t>(motion_.box_width / cell));
    const bool wraps = motion_.periodic;
    const auto column_of = [&](double x) {
      const double inside = wraps ? x - motion_.box_width * std::floor(x / motion_.box_width) : x;
      const auto column =
          static_cast<std::int64_t>(std::floor(inside / motion_.box_width * static_cast<double>(columns)));
      return wraps ? column % columns : column;
    };
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < motion_.beads(); ++i) {
      if (!std::isfinite(place(i).x + place(i).z)) continue;
      const std::int64_t column = column_of(place(i).x), row = static_cast<std::int64_t>(std::floor(place(i).z / cell));
      std::vector<std::int64_t> beside{column - 1, column, column + 1};
      if (wraps) {
        for (std::int64_t& c : beside) c = (c + columns) % columns;
        std::ranges::sort(beside);
        beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
      }
      for (const std::int64_t c : beside)
        for (std::int64_t r = row - 1; r <= row + 1; ++r)
          if (const auto others = cells.find({c, r}); others != cells.end())
            for (const std::size_t j : others->second) pairs.emplace_back(i, j);
      cells[{column, row}].push_back(i);
    }
    return pairs;
  }

  /// Eqs. (3), (4): along the normal n to bead i the law of the contact, across it -D_t m_ij v_t.
  void add(std::size_t i, std::size_t j, double overlap, const Vec& n, const Vec& relative, double K, double C,
           double T) {
    if (!(overlap > 0.0)) return;
    const double rate = -dot(relative, n);
    const double along =
        visit_law(laws_.exponents, [&](const auto& law) { return where_closed(law, K, C, overlap, rate); });
    const Vec across = relative + rate * n, force = along * n - T * across;
    found_.push_back({i, j, overlap, {force.x, 0.0, force.z}});
  }
  void touch_wall(std::size_t i, const Vec& n, double distance, const Vec& wall_speed) {
    const double m = motion_.mass[i];
    add(i, FilmContact::wall, radius(i) - distance, n, speed(i) - wall_speed, laws_.K_wall, laws_.C_wall * m,
        p_.D_t * m);
  }
  void touch(std::size_t i, std::size_t j) {
    Vec r = place(i) - place(j);
    if (motion_.periodic) r.x -= motion_.box_width * std::round(r.x / motion_.box_width);
    const double distance = std::sqrt(dot(r, r));
    if (!(distance > 0.0)) return;
    const double m = motion_.mass[i], n = motion_.mass[j], m_ij = 2 * m * n / (m + n);
    add(i, j, radius(i) + radius(j) - distance, (1 / distance) * r, speed(i) - speed(j), laws_.K, laws_.C * m_ij,
        p_.D_t * m_ij);
  }

  const Parameters& p_;
  const Column<double>& laws_;
  const Trajectory& motion_;
  std::size_t first_;
  std::vector<FilmContact> found_;
};

}  // namespace

std::vector<FilmContact> column_contacts(const Parameters& p, const Column<double>& contact_laws,
                                         const Trajectory& motion, std::size_t sample) {
  const Bottom bottom = bottom_at(p, motion.time[sample]);
  const std::size_t first = sample * motion.beads();
  std::vector<FilmContact> found;
  for (std::size_t k = 0; k < motion.beads(); ++k) {  // contact k is below bead k, counted from 0
    const double z = motion.z[first + k], v = motion.velocity[first + k];
    const double overlap = (k == 0 ? bottom.height : motion.z[first + k - 1]) - z;
    if (!(overlap > 0.0)) continue;
    const double rate = (k == 0 ? bottom.speed : motion.velocity[first + k - 1]) - v;
    const double force = visit_law(contact_laws.exponents, [&](const auto& law) {
      return where_closed(law, contact_laws.spring(k), contact_laws.dashpot(k), overlap, rate);
    });
    found.push_back({k, k == 0 ? FilmContact::wall : k - 1, overlap, {0.0, 0.0, force}});
  }
  return found;
}

std::vector<FilmContact> lattice_contacts(const Parameters& p, const Column<double>& contact_laws,
                                          const Trajectory& motion, std::size_t sample) {
  return Discs(p, contact_laws, motion, sample).contacts();
}

}  // namespace sigmasweep
