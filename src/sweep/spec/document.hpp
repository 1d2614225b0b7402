#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/spec/tables.hpp"

namespace sigmasweep::spec {

/// A spec as it was read: its tables as values or, where reading them needs the sweep, as they stand in the text.
/// Entries refer to `toml` and `file`: a document stays where it is.
struct Document {
  Document(std::string_view text, std::string file);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  std::string text, file;
  toml::table toml;
  std::string title;
  RunSpec run;
  std::optional<Grid> grid;  ///< always there once the document is read
  std::optional<Entry> trajectory;
  std::vector<PlotSpec> plots;
  std::vector<Entry> sections;  ///< tables that are not the sweep's own
};

/// Reads the sweep's own tables. A table of another name must be one of `sections`, unless `any_section`.
void read_tables(Document& document, std::span<const SpecSection> sections, bool any_section);

}  // namespace sigmasweep::spec
