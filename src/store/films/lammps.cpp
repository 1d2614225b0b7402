#include <fmt/format.h>

#include <iterator>

#include "store/films/formats.hpp"

/// Dump files of LAMMPS, https://docs.lammps.org/dump.html, which OVITO and VMD read: row-000042.lammpstrj with the
/// beads, and of soft spheres row-000042.contacts.lammpstrj, a local dump with the contacts. Units are SI, and the mean
/// bead's mass. The step is the sample's number. There is no ITEM: TIME, which MDAnalysis does not read.
namespace sigmasweep {
namespace {

void put_head(std::string& text, const Film& film, std::size_t sample, std::string_view what, std::size_t count) {
  const auto [low, high] = film.box();
  fmt::format_to(std::back_inserter(text), "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\n", sample, what, count);
  fmt::format_to(std::back_inserter(text), "ITEM: BOX BOUNDS {} ff ff\n{} {}\n{} {}\n{} {}\n",
                 film.is_periodic() ? "pp" : "ff", low[0], high[0], low[1], high[1], low[2], high[2]);
}

std::string beads(const Film& film) {
  std::string text;
  for (std::size_t s = 0; s < film.samples(); ++s) {
    put_head(text, film, s, "ATOMS", film.beads());
    text += "ITEM: ATOMS id type x y z vx vy vz radius mass";
    text += film.has_forces() ? " fx fy fz\n" : "\n";
    const auto forces = film.has_forces() ? film.forces(film.contacts(s)) : std::vector<Vec3>{};
    for (std::size_t i = 0; i < film.beads(); ++i) {
      fmt::format_to(std::back_inserter(text), "{} 1 {} {} {} {}", i + 1, fmt::join(film.position(s, i), " "),
                     fmt::join(film.velocity(s, i), " "), film.radius(i), film.mass(i));
      if (film.has_forces()) fmt::format_to(std::back_inserter(text), " {}", fmt::join(forces[i], " "));
      text += '\n';
    }
  }
  return text;
}

/// A wall is number 0.
std::string contacts(const Film& film) {
  std::string text;
  for (std::size_t s = 0; s < film.samples(); ++s) {
    const auto found = film.contacts(s);
    put_head(text, film, s, "ENTRIES", found.size());
    text += "ITEM: ENTRIES i j overlap fx fy fz\n";
    for (const FilmContact& contact : found)
      fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", contact.i + 1, contact.j + 1, contact.overlap,
                     fmt::join(contact.force, " "));
  }
  return text;
}

}  // namespace

FilmFormat lammps_film() {
  return {"lammps", "dump files of LAMMPS, for OVITO and VMD: beads, and of soft spheres the contacts",
          [](const Film& film, const PutFile& put) {
            put(film_stem(film.row()) + ".lammpstrj", beads(film));
            if (film.has_forces()) put(film_stem(film.row()) + ".contacts.lammpstrj", contacts(film));
          }};
}

}  // namespace sigmasweep
