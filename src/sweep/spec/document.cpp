#include "sweep/spec/document.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "model/fields/conditions.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sweep/spec/plot.hpp"
#include "sweep/spec/run.hpp"
#include "sweep/spec/trajectory.hpp"
#include "sweep/toml/parse_toml.hpp"

namespace sigmasweep::spec {
namespace {

constexpr auto own_keys = std::to_array<KeyInfo>({
    {"title", KeyForm::text, "the sweep's name, in the table and above pictures", "none"},
    {.name = "sweep",
     .form = KeyForm::one_or_several,
     .meaning = "the tuples: parameters and axes; of several [[sweep]] one after the other",
     .keys = keys_of_sweep},
    {.name = "defaults",
     .form = KeyForm::table,
     .meaning = "keys of each [[sweep]] that does not have them itself",
     .usual = "none",
     .keys = keys_of_sweep},
    {.name = "plot",
     .form = KeyForm::one_or_several,
     .meaning = "the pictures that 'sigmasweep plot' draws",
     .usual = "one of eps_eff against sigma; vibrated: of h_cm_excess against alpha",
     .keys = keys_of_plot},
    {.name = "run",
     .form = KeyForm::table,
     .meaning = "how the sweep is computed; no result depends on it",
     .keys = keys_of_run},
    {.name = "trajectory",
     .form = KeyForm::table,
     .meaning = "rows whose motion is recorded, an H5MD file each",
     .usual = "none",
     .keys = keys_of_trajectory},
});

/// Refuses a plot whose data the sweep does not have.
void require_plottable(const Entry& entry, const PlotSpec& plot, const Document& document) {
  const auto& tuples = document.tuples->representatives();
  const bool films = plot.kind == PlotKind::trajectories;
  if (films && !document.trajectory) refuse(entry, "kind = 'trajectories' needs a table [trajectory]");
  if (plot.by_phase && std::ranges::none_of(tuples, conditions::vibrates.holds))
    refuse(entry, "x = 'phase' needs geometry = 'vibrated-column' or 'vibrated-lattice'");
  const auto is_vibrated_lattice = [](const Parameters& p) {
    return conditions::vibrates.holds(p) && conditions::lattice.holds(p);
  };
  if (films && !plot.mean_over.empty() && !(plot.by_phase && std::ranges::any_of(tuples, is_vibrated_lattice)))
    refuse(entry, "'mean_over' of trajectories needs x = 'phase' and geometry = 'vibrated-lattice'");
}

std::vector<PlotSpec> plots_of(const std::optional<Entry>& entry, const Document& document) {
  const PlotSpec usual = document.tuples ? usual_plot(document.tuples->representatives()) : PlotSpec{};
  if (!entry) return {usual};
  std::vector<PlotSpec> plots = read_plots(*entry, usual);
  if (!document.tuples) return plots;  // there are mistakes in [sweep]
  for (const PlotSpec& plot : plots) require_plottable(*entry, plot, document);
  return plots;
}

void read_tuples(Document& document, const Entry& sweep, const std::optional<Entry>& defaults, bool keys_alone) {
  if (keys_alone)
    require_readable(sweep, defaults);
  else
    document.tuples.emplace(sweep, defaults);
}

void require_known(const Entry& entry, std::span<const SpecSection> sections) {
  std::vector<std::string_view> known;
  for (const KeyInfo& key : keys_of_spec(sections)) known.push_back(key.name);
  if (std::ranges::find(known, entry.name) == known.end()) refuse_unknown(entry, known);
}

}  // namespace

Document::Document(std::string_view given, std::string name)
    : text(given), file(std::move(name)), toml(parse_toml(text, file, mistakes)) {}

void read_tables(Document& document, std::span<const SpecSection> sections, bool any_section) {
  Mistakes& mistakes = document.mistakes;
  const bool has_syntax_mistakes = mistakes.are_there();  // lines are left out: keys may be missing
  const auto tables = entries(document.toml, document.file, "");
  std::optional<Entry> plot, defaults;
  for (const Entry& entry : tables)
    if (entry.name == "defaults") defaults = entry;
  const auto read = [&](const Entry& entry) {
    if (!any_section) require_known(entry, sections);
    if (entry.name == "title")
      document.title = as_string(entry);
    else if (entry.name == "sweep")
      read_tuples(document, entry, defaults, has_syntax_mistakes);
    else if (entry.name == "defaults")
      as_table(entry);
    else if (entry.name == "plot")
      plot = entry;
    else if (entry.name == "run")
      document.run = read_run(entry);
    else if (entry.name == "trajectory")
      require_trajectory_keys(*(document.trajectory = entry));
    else
      document.sections.push_back(entry);
  };
  for (const Entry& entry : tables) mistakes.keep([&] { read(entry); });
  mistakes.keep([&] { document.plots = plots_of(plot, document); });
  mistakes.refuse_any(Mistakes::readable);
  if (!document.tuples) throw SpecError(fmt::format("{}: the table [sweep] is missing", document.file));
}

std::vector<KeyInfo> keys_of_spec(std::span<const SpecSection> sections) {
  std::vector<KeyInfo> keys(own_keys.begin(), own_keys.end());
  for (const SpecSection& section : sections)
    keys.push_back({.name = section.name, .form = KeyForm::table, .meaning = section.meaning, .keys = section.keys});
  return keys;
}

}  // namespace sigmasweep::spec
