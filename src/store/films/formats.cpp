#include "store/films/formats.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

/// The formats of films. A file of this folder defines NAME_film().
// clang-format off
#define SIGMASWEEP_FILM_FORMATS(X) \
  X(lammps) \
  X(xyz) \
  X(vtk) \
  /* a line for each */
// clang-format on

namespace sigmasweep {

#define SIGMASWEEP_DECLARE(name) FilmFormat name##_film();
SIGMASWEEP_FILM_FORMATS(SIGMASWEEP_DECLARE)

std::span<const FilmFormat> film_formats() {
#define SIGMASWEEP_MAKE(name) name##_film(),
  static const auto formats = std::to_array<FilmFormat>({SIGMASWEEP_FILM_FORMATS(SIGMASWEEP_MAKE)});
  return formats;
}

std::optional<FilmFormat> film_format(std::string_view name) {
  const auto found = std::ranges::find(film_formats(), name, &FilmFormat::name);
  if (found == film_formats().end()) return std::nullopt;
  return *found;
}

std::string film_stem(std::uint64_t row) { return fmt::format("row-{:06}", row); }

}  // namespace sigmasweep
