#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/sweep/sweep.hpp"
#include "sweep/spec/entry.hpp"
#include "sweep/spec/key.hpp"
#include "sweep/spec/tuples/tuples.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {

/// A spec after reading. Tables that cannot be read without the sweep are kept as entries. Entries refer to `toml` and
/// `file`, so that a document cannot be copied or moved.
struct Document {
  Document(std::string_view text, std::string file);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  std::string text, file;
  Mistakes mistakes;  ///< of syntax, until read_tables() adds the others and reports them
  toml::table toml;
  std::string title;
  RunSpec run;
  std::optional<Tuples> tuples;  ///< has a value after read_tables()
  std::optional<Entry> trajectory;
  std::vector<PlotSpec> plots;
  std::vector<Entry> sections;  ///< tables that belong to studies
};

/// Reads the sweep's own tables. Another table must have the name of one of `sections`, unless `any_section`.
void read_tables(Document& document, std::span<const SpecSection> sections, bool any_section);

/// The keys of a spec outside all tables: its title, and its tables.
std::vector<KeyInfo> keys_of_spec(std::span<const SpecSection> sections);

}  // namespace sigmasweep::spec
