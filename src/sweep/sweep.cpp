#include "sigmasweep/sweep/sweep.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <xxhash.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/spec/tables.hpp"
#include "sweep/spec/toml_guard.hpp"

namespace sigmasweep {
namespace {

constexpr std::array<std::string_view, 6> tables{"title", "sweep", "plot", "run", "trajectory", "precision"};
/// Parameters that are members whether they are axes or not.
constexpr std::array<std::string_view, 7> of_what_flies{"v0", "tc", "s0", "sigma", "N", "epsilon", "method"};
constexpr std::array<std::string_view, 7> of_what_vibrates{"N",     "epsilon", "method", "frequency",
                                                           "alpha", "A0",      "periods"};
constexpr std::array<std::string_view, 2> of_lattices{"rows", "columns"};

toml::table parse_toml(std::string_view text, const std::string& file) {
  spec::require_parsable(text, file);
  try {
    return toml::parse(text, std::string_view(file));
  } catch (const toml::parse_error& error) {
    throw SpecError(spec::place(file, error.source().begin.line) + std::string(error.description()));
  }
}

bool is_fixed(const Field& field, const std::vector<Parameters>& kinds) {
  const auto is_among = [&](std::span<const std::string_view> names) {
    return std::ranges::find(names, field.name) != names.end();
  };
  return std::ranges::any_of(kinds, [&](const Parameters& kind) {
    if (is_lattice(kind) && is_among(of_lattices)) return true;
    if (field.name == "tc" && (kind.method == Method::md || kind.ed_rule == EdRule::tc)) return true;
    return is_vibrated(kind) ? is_among(of_what_vibrates) : is_among(of_what_flies);
  });
}

std::vector<Field> columns_of(const spec::Grid& grid) {
  std::vector<Field> columns;
  for (const Field& field : parameter_fields())
    if (is_fixed(field, grid.kinds) || std::ranges::find(grid.axes, &field) != grid.axes.end())
      columns.push_back(field);
  for (const Field& field : result_fields())
    if (std::ranges::any_of(grid.kinds, [&](const Parameters& kind) { return applies_to(field, kind); }))
      columns.push_back(field);
  return columns;
}

}  // namespace

struct Sweep::Impl {
  std::string title, text;
  std::uint64_t hash;
  std::vector<PlotSpec> plots;
  ManagerRole manager = ManagerRole::automatic;
  spec::Grid grid;
  std::vector<std::string> axes;
  std::vector<Field> columns;
  std::optional<TrajectorySpec> trajectory;
  std::optional<double> tuple_time_limit{};
  std::optional<PrecisionSpec> precision{};
};

Sweep::Sweep(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Sweep Sweep::parse(std::string_view text, const std::string& file) {
  const toml::table document = parse_toml(text, file);
  std::string title;
  spec::RunTable run;
  std::optional<spec::Grid> grid;
  std::optional<spec::Entry> trajectory, precision, plot;
  for (const spec::Entry& entry : spec::entries(document, file, "")) {
    if (entry.name == "title")
      title = spec::as_string(entry);
    else if (entry.name == "sweep")
      grid = spec::read_sweep(entry);
    else if (entry.name == "plot")
      plot = entry;
    else if (entry.name == "run")
      run = spec::read_run(entry);
    else if (entry.name == "trajectory")
      trajectory = entry;
    else if (entry.name == "precision")
      precision = entry;
    else
      spec::refuse_unknown(entry, tables);
  }
  if (!grid) throw SpecError(fmt::format("{}: the table [sweep] is missing", file));
  std::vector<PlotSpec> plots{spec::usual_plot(*grid)};
  if (plot) plots = spec::read_plots(*plot, plots[0]);
  for (const PlotSpec& one : plots) {
    if (one.kind == PlotKind::trajectories && !trajectory)
      spec::refuse(*plot, "kind = 'trajectories' needs a table [trajectory]");
    if (one.by_phase && std::ranges::none_of(grid->kinds, is_vibrated))
      spec::refuse(*plot, "x = 'phase' needs geometry = 'vibrated-column' or 'vibrated-lattice'");
    const auto is_film = [](const Parameters& p) { return p.geometry == Geometry::vibrated_lattice; };
    if (one.kind == PlotKind::trajectories && !one.mean_over.empty() &&
        !(one.by_phase && std::ranges::any_of(grid->kinds, is_film)))
      spec::refuse(*plot, "'mean_over' of trajectories needs x = 'phase' and geometry = 'vibrated-lattice'");
  }

  std::vector<std::string> axes;
  for (const Field* field : grid->axes) axes.emplace_back(field->name);
  auto columns = columns_of(*grid);
  const auto impl = std::make_shared<Impl>(Impl{std::move(title),
                                                std::string(text),
                                                XXH3_64bits(text.data(), text.size()),
                                                std::move(plots),
                                                run.manager,
                                                *std::move(grid),
                                                std::move(axes),
                                                std::move(columns),
                                                {},
                                                {}});
  const Sweep sweep(impl);
  impl->tuple_time_limit = run.tuple_time_limit;
  if (trajectory) impl->trajectory = spec::read_trajectory(*trajectory, sweep);
  if (precision) impl->precision = spec::read_precision(*precision, sweep);
  return sweep;
}

Sweep Sweep::load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(spec::max_text + 1, '\0');
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream && !stream.eof()) throw InputNotFound(fmt::format("{}: cannot be read as a sweep spec", path));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse(text, path);
}

const std::string& Sweep::title() const { return impl_->title; }
const std::string& Sweep::text() const { return impl_->text; }
std::uint64_t Sweep::hash() const { return impl_->hash; }
const std::vector<PlotSpec>& Sweep::plots() const { return impl_->plots; }
ManagerRole Sweep::manager() const { return impl_->manager; }
std::optional<double> Sweep::tuple_time_limit() const { return impl_->tuple_time_limit; }
const std::optional<TrajectorySpec>& Sweep::trajectory() const { return impl_->trajectory; }
const std::optional<PrecisionSpec>& Sweep::precision() const { return impl_->precision; }
const std::vector<std::string>& Sweep::axes() const { return impl_->axes; }
const std::vector<std::uint64_t>& Sweep::axis_sizes() const { return impl_->grid.axis_sizes; }
const std::vector<Field>& Sweep::columns() const { return impl_->columns; }

std::uint64_t Sweep::size() const {
  return impl_->grid.selection ? impl_->grid.selection->size() : impl_->grid.product.size();
}

Parameters Sweep::at(std::uint64_t row) const {
  if (row >= size()) throw std::out_of_range(fmt::format("row {} of a sweep of {} rows", row, size()));
  return impl_->grid.product.at(impl_->grid.selection ? (*impl_->grid.selection)[row] : row);
}

}  // namespace sigmasweep
