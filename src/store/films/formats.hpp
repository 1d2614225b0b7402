#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "store/films/film.hpp"

namespace sigmasweep {

/// Takes the text of a file, by its name within the directory of the films.
using PutFile = std::function<void(const std::string& name, const std::string& text)>;

/// A format of films. Each file in store/films that defines a NAME_film() is one, and formats.cpp lists them.
struct FilmFormat {
  std::string_view name;
  std::string_view meaning;  ///< a line for help
  void (*write)(const Film& film, const PutFile& put);
};

/// The stem of a row's files: row-000042.
std::string film_stem(std::uint64_t row);

std::span<const FilmFormat> film_formats();
/// The format of this name; nothing if there is none.
std::optional<FilmFormat> film_format(std::string_view name);

}  // namespace sigmasweep
