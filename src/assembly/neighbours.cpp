#include "assembly/neighbours.hpp"

#include <algorithm>
#include <numbers>

namespace sigmasweep {
namespace {

/// Largest distance of the centres of neighbours, in largest diameters.
constexpr double reach_of_lists = 1.6;

template <class Real>
std::int64_t whole(const Real& x) {
  using std::floor;
  return static_cast<std::int64_t>(floor(x));
}

}  // namespace

template <class Real>
LatticeNeighbours<Real>::LatticeNeighbours(const Lattice<Real>& lattice)
    : lattice_(lattice),
      width_(lattice.width()),
      reach_(std::max(Real(reach_of_lists) * lattice.largest, Real(1.01) * lattice.a)),
      leeway_((reach_ - lattice.largest) / 2),
      columns_(std::max<std::int64_t>(1, whole<Real>(width_ / reach_))),
      anchor_(lattice.shift),
      cell_of_(lattice.count()),
      lists_(lattice.count()) {
  anchor_.resize(lattice.count());
  for (std::size_t i = 0; i < lattice.count(); ++i) site_.push_back(lattice.site(i));
  for (std::size_t i = 0; i < lattice.count(); ++i) enter(i);
  for (std::size_t i = 0; i < lattice.count(); ++i) lists_[i] = find(i);
}

template <class Real>
auto LatticeNeighbours<Real>::cell(std::int64_t column, std::int64_t row) const -> Cell {
  return row * columns_ + ((column % columns_) + columns_) % columns_;
}

template <class Real>
void LatticeNeighbours<Real>::enter(std::size_t i) {
  const Vec2<Real> at = position(i);
  cell_of_[i] = cell(whole<Real>(at.x / width_ * Real(double(columns_))), whole<Real>(at.z / reach_));
  cells_[cell_of_[i]].push_back(static_cast<std::uint32_t>(i));
}

template <class Real>
void LatticeNeighbours<Real>::leave(std::size_t i) {
  const auto cell = cells_.find(cell_of_[i]);
  std::erase(cell->second, static_cast<std::uint32_t>(i));
  if (cell->second.empty()) cells_.erase(cell);
}

template <class Real>
void LatticeNeighbours<Real>::forget(std::size_t i) {
  for (const Neighbour<Real>& other : lists_[i])
    if (!other.is_wall())
      std::erase_if(lists_[other.bead], [&](const Neighbour<Real>& back) { return back.bead == i; });
}

template <class Real>
const std::vector<Neighbour<Real>>& LatticeNeighbours<Real>::move(std::size_t i, const Vec2<Real>& q) {
  const std::vector<Neighbour<Real>> before = lists_[i];
  forget(i);
  leave(i);
  anchor_[i] = q;
  enter(i);
  lists_[i] = find(i);
  fresh_.clear();
  for (const Neighbour<Real>& other : lists_[i]) {
    if (!other.is_wall()) lists_[other.bead].push_back(other.seen_from_there(static_cast<std::uint32_t>(i)));
    if (std::ranges::none_of(before, [&](const Neighbour<Real>& old) { return old.is(other.bead, other.image); }))
      fresh_.push_back(other);
  }
  return fresh_;
}

template <class Real>
std::vector<Neighbour<Real>> LatticeNeighbours<Real>::find(std::size_t i) const {
  std::vector<Neighbour<Real>> found;
  const Vec2<Real> at = position(i);
  const std::int64_t column = whole<Real>(at.x / width_ * Real(double(columns_))), row = whole<Real>(at.z / reach_);
  const std::int64_t sides = std::min<std::int64_t>(columns_, 3);  // a narrow container has each column once
  for (std::int64_t r = row - 1; r <= row + 1; ++r)
    for (std::int64_t c = 0; c < sides; ++c)
      if (const auto others = cells_.find(cell(column - 1 + c, r)); others != cells_.end())
        for (const std::uint32_t j : others->second)
          if (j != i) add_images(i, j, found);
  add_walls(i, found);
  std::ranges::sort(found, {}, [](const Neighbour<Real>& n) { return std::pair(n.bead, n.image); });
  return found;
}

template <class Real>
void LatticeNeighbours<Real>::add_images(std::size_t i, std::size_t j, std::vector<Neighbour<Real>>& found) const {
  const Vec2<Real> apart = position(i) - position(j);
  const auto add = [&](std::int64_t image) {
    const Real x = apart.x - Real(double(image)) * width_;
    if (x * x + apart.z * apart.z > reach_ * reach_) return;
    const auto n = static_cast<std::int32_t>(image);
    found.push_back({static_cast<std::uint32_t>(j), n, bond(i, j, n)});
  };
  if (!lattice_.periodic) return add(0);
  const std::int64_t last = whole<Real>((apart.x + reach_) / width_);
  for (std::int64_t image = -whole<Real>((reach_ - apart.x) / width_); image <= last; ++image) add(image);
}

template <class Real>
void LatticeNeighbours<Real>::add_walls(std::size_t i, std::vector<Neighbour<Real>>& found) const {
  const auto add = [&](std::uint32_t wall, const Vec2<Real>& normal, const Real& from_first) {
    const Bond<Real> bond{normal, Real(0),
                          lattice_.beads.gap + (lattice_.largest - lattice_.diameter(i)) / 2 + from_first};
    if (bond.gap(anchor_[i]) <= 2 * leeway_) found.push_back({wall, 0, bond});
  };
  const auto per_row = static_cast<std::size_t>(lattice_.columns);
  const Real row(double(i / per_row)), place(double(i % per_row) + (i / per_row % 2 == 1 ? 0.5 : 0.0));
  add(Neighbour<Real>::bottom, {Real(0), Real(1)}, row * lattice_.a * (std::numbers::sqrt3_v<Real> / 2));
  if (lattice_.periodic) return;
  add(Neighbour<Real>::left, {Real(1), Real(0)}, place * lattice_.a);
  add(Neighbour<Real>::right, {Real(-1), Real(0)}, (Real(double(lattice_.columns) - 0.5) - place) * lattice_.a);
}

/// Distances of sites in half lattice constants are whole numbers, so that neighbours are recognised exactly.
template <class Real>
Bond<Real> LatticeNeighbours<Real>::bond(std::size_t i, std::size_t j, std::int32_t image) const {
  using std::sqrt;
  const auto halves = [&](std::size_t k) {
    const auto n = static_cast<std::int64_t>(k), row = n / lattice_.columns;
    return std::pair(2 * (n % lattice_.columns) + row % 2, row);
  };
  const auto [x_i, z_i] = halves(i);
  const auto [x_j, z_j] = halves(j);
  const std::int64_t x = x_i - x_j - 2 * image * lattice_.columns, z = z_i - z_j, squared = x * x + 3 * z * z;
  const Real a = lattice_.a, sum = (lattice_.diameter(i) + lattice_.diameter(j)) / 2;
  const Vec2<Real> R{Real(double(x)) * a / 2, Real(double(z)) * a * (std::numbers::sqrt3_v<Real> / 2)};
  if (squared == 4) return {R, a, lattice_.beads.gap + (lattice_.largest - sum)};
  const Real length = a * sqrt(Real(double(squared))) / 2;
  return {R, length, length - sum};
}

template class LatticeNeighbours<double>;
template class LatticeNeighbours<long double>;

}  // namespace sigmasweep
