#pragma once

#include <array>
#include <string_view>

#include "sigmasweep/model/parameters.hpp"

/// The table of geometries: how the beads are put together and what they meet.
namespace sigmasweep {

/// What the beads form: a column, of one dimension; or a triangular lattice, of two.
enum class Assembly : std::uint8_t { column, lattice };

/// What the lowest beads meet: a fixed wall, without gravity; or a plate that vibrates, under gravity.
enum class GroundKind : std::uint8_t { wall, plate };

struct GeometryInfo {
  Geometry id;
  std::string_view name;  ///< as users write it
  Assembly assembly;
  GroundKind ground;
};

/// All geometries, in the order of Geometry.
inline constexpr std::array geometries{
    GeometryInfo{Geometry::column, "column", Assembly::column, GroundKind::wall},
    GeometryInfo{Geometry::vibrated_column, "vibrated-column", Assembly::column, GroundKind::plate},
    GeometryInfo{Geometry::lattice, "lattice", Assembly::lattice, GroundKind::wall},
    GeometryInfo{Geometry::vibrated_lattice, "vibrated-lattice", Assembly::lattice, GroundKind::plate},
};
static_assert(geometries.size() == static_cast<std::size_t>(Geometry::vibrated_lattice) + 1);
constexpr auto enumerator_names(Geometry) { return names_in(geometries); }

constexpr const GeometryInfo& geometry_of(const Parameters& p) {
  return geometries[static_cast<std::size_t>(p.geometry)];
}
/// Whether the beads meet a plate that vibrates.
constexpr bool is_vibrated(const Parameters& p) { return geometry_of(p).ground == GroundKind::plate; }
/// Whether the beads form a lattice, of two dimensions.
constexpr bool is_lattice(const Parameters& p) { return geometry_of(p).assembly == Assembly::lattice; }

}  // namespace sigmasweep
