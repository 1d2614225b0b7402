#include <fmt/format.h>

#include <iterator>

#include "store/films/formats.hpp"

/// Extended XYZ, https://github.com/libAtoms/extxyz, which ASE, OVITO and VMD read: row-000042.xyz. Units are SI, and
/// the mean bead's mass.
namespace sigmasweep {
namespace {

std::string frame(const Film& film, std::size_t s) {
  const auto [low, high] = film.box();
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{}\" pbc=\"{} F F\" Time={} "
      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1",
      film.beads(), high[0] - low[0], high[1] - low[1], high[2] - low[2], fmt::join(low, " "),
      film.is_periodic() ? "T" : "F", film.time(s));
  text += film.has_forces() ? ":forces:R:3\n" : "\n";
  const auto forces = film.has_forces() ? film.forces(film.contacts(s)) : std::vector<Vec3>{};
  for (std::size_t i = 0; i < film.beads(); ++i) {
    fmt::format_to(std::back_inserter(text), "X {} {} {} {}", fmt::join(film.position(s, i), " "),
                   fmt::join(film.velocity(s, i), " "), film.radius(i), film.mass(i));
    if (film.has_forces()) fmt::format_to(std::back_inserter(text), " {}", fmt::join(forces[i], " "));
    text += '\n';
  }
  return text;
}

}  // namespace

FilmFormat xyz_film() {
  return {"xyz", "extended XYZ, for ASE, OVITO and VMD", [](const Film& film, const PutFile& put) {
            std::string text;
            for (std::size_t s = 0; s < film.samples(); ++s) text += frame(film, s);
            put(film_stem(film.row()) + ".xyz", text);
          }};
}

}  // namespace sigmasweep
