#include "sweep/spec/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/geometry.hpp"
#include "sweep/expression/formula.hpp"
#include "sweep/expression/where.hpp"
#include "sweep/spec/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

constexpr auto plot_keys =
    std::to_array<std::string_view>({"name", "kind", "x", "y", "x_label", "y_label", "x_scale", "y_scale", "series",
                                     "title", "where", "mean_over", "lines", "fit", "guides", "y_error"});
constexpr std::array<std::string_view, 3> fit_keys{"form", "from", "to"};
constexpr std::array<std::string_view, 7> guide_keys{"slope", "y", "label", "through", "where", "from", "to"};
constexpr std::array<std::string_view, 3> kinds{"points", "trajectories", "stability"};
constexpr std::array<std::string_view, 2> scales{"linear", "log"}, film_axes{"time", "phase"};
constexpr std::array<std::string_view, 2> forms{"power", "line"};
constexpr std::size_t max_plots = 100;

std::string as_field(const Entry& entry) {
  std::string name = as_string(entry);
  if (find_field(name) == nullptr) refuse_value(entry, "is no field of a row" + hint(name, field_names()));
  return name;
}

/// Names of fields: one name, or a list.
std::vector<std::string> as_fields(const Entry& entry) {
  if (entry.node->is_string()) return {as_field(entry)};
  std::vector<std::string> fields;
  for (const Entry& element : elements(entry)) fields.push_back(as_field(element));
  return fields;
}

/// A name of a field, or an expression of this kind.
template <class Kind>
std::string as_expression(const Entry& entry) {
  std::string text = as_string(entry);
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (std::all_of(text.begin(), text.end(), is_letter)) as_field(entry);
  try {
    Kind(text, all_fields());
  } catch (const UsageError& error) {
    refuse_value(entry, error.what());
  }
  return text;
}

double as_finite(const Entry& entry) {
  const double value = as_number(entry);
  if (!std::isfinite(value)) refuse_value(entry, "must be finite");
  return value;
}

/// The name of a plot, which becomes a part of a file's name.
std::string as_name(const Entry& entry) {
  std::string name = as_string(entry);
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name.empty() || name.size() > 60 || !std::all_of(name.begin(), name.end(), allowed))
    refuse_value(entry, "must be at most 60 letters, digits, '-' and '_'");
  return name;
}

FitSpec read_fit(const Entry& table) {
  FitSpec fit;
  for (const Entry& entry : entries(as_table(table), *table.file, table.path)) {
    if (entry.name == "form")
      fit.form = static_cast<FitSpec::Form>(as_one_of(entry, forms));
    else if (entry.name == "from")
      fit.from = as_finite(entry);
    else if (entry.name == "to")
      fit.to = as_finite(entry);
    else
      refuse_unknown(entry, fit_keys);
  }
  if (!(fit.from < fit.to)) refuse(table, "'from' must be less than 'to'");
  return fit;
}

std::array<double, 2> as_point(const Entry& entry) {
  const auto coordinates = elements(entry);
  if (coordinates.size() != 2) refuse_value(entry, "must be a point [x, y]");
  return {as_finite(coordinates[0]), as_finite(coordinates[1])};
}

std::string as_function(const Entry& entry) {
  std::string text = as_string(entry);
  try {
    FunctionOfX{text};
  } catch (const UsageError& error) {
    refuse_value(entry, error.what());
  }
  return text;
}

GuideSpec read_guide(const Entry& table) {
  GuideSpec guide;
  bool sloped = false;
  for (const Entry& entry : entries(as_table(table), *table.file, table.path)) {
    if (entry.name == "label")
      guide.label = as_string(entry);
    else if (entry.name == "slope")
      guide.slope = as_finite(entry), sloped = true;
    else if (entry.name == "y" && entry.node->is_string())
      guide.curve = as_function(entry);
    else if (entry.name == "y")
      guide.y = as_finite(entry);
    else if (entry.name == "through")
      guide.through = as_point(entry);
    else if (entry.name == "where")
      guide.where = as_expression<Where>(entry);
    else if (entry.name == "from")
      guide.from = as_finite(entry);
    else if (entry.name == "to")
      guide.to = as_finite(entry);
    else
      refuse_unknown(entry, guide_keys);
  }
  const bool has_y = guide.y || !guide.curve.empty();
  if (sloped == has_y) refuse(table, "a guide has either 'slope' or 'y'");
  if (has_y && (guide.through || !guide.where.empty())) refuse(table, "'through' and 'where' belong to 'slope'");
  if (guide.through && !guide.where.empty()) refuse(table, "give 'through' or 'where', not both");
  if (!(guide.from < guide.to)) refuse(table, "'from' must be less than 'to'");
  return guide;
}

std::vector<GuideSpec> read_guides(const Entry& list) {
  constexpr std::size_t most = 100;
  const std::vector<Entry> tables = elements(list);
  if (tables.size() > most) refuse(list, fmt::format("{} guides, but at most {} are allowed", tables.size(), most));
  std::vector<GuideSpec> guides;
  Mistakes mistakes;
  for (const Entry& table : tables) mistakes.keep([&] { guides.push_back(read_guide(table)); });
  mistakes.refuse_any();
  return guides;
}

void require_drawable(const PlotSpec& plot, const Entry& table) {
  for (const GuideSpec& guide : plot.guides) {
    if (!guide.y && guide.curve.empty() && plot.x_log != plot.y_log)
      refuse(table, "a guide with a slope needs two logarithmic axes, or two linear ones");
    if (guide.through && plot.x_log && !((*guide.through)[0] > 0.0 && (*guide.through)[1] > 0.0))
      refuse(table, "on logarithmic axes a guide must go through a point with x > 0 and y > 0");
    if (guide.y && plot.y_log && !(*guide.y > 0.0)) refuse(table, "on a logarithmic axis a guide's y must be > 0");
  }
}

void require_keys_of(PlotKind kind, const Entry& plot) {
  if (kind == PlotKind::points) return;
  std::vector<std::string_view> keys{"name", "kind", "title", "where"};
  if (kind == PlotKind::stability) keys.insert(keys.end(), {"y", "y_scale"});
  if (kind == PlotKind::trajectories) keys.insert(keys.end(), {"x", "mean_over"});
  for (const Entry& entry : entries(as_table(plot), *plot.file, plot.path))
    if (std::ranges::find(keys, entry.name) == keys.end())
      refuse(entry, fmt::format("is not used by a plot of kind '{}'", kinds[static_cast<std::size_t>(kind)]));
}

PlotKind kind_of(const std::vector<Entry>& keys) {
  const auto kind = std::ranges::find(keys, "kind", &Entry::name);
  return kind == keys.end() ? PlotKind::points : static_cast<PlotKind>(as_one_of(*kind, kinds));
}

void read_key(const Entry& entry, PlotSpec& spec) {
  if (entry.name == "kind") return;
  if (entry.name == "name")
    spec.name = as_name(entry);
  else if (entry.name == "x" && spec.kind == PlotKind::trajectories)
    spec.by_phase = as_one_of(entry, film_axes) == 1;
  else if (entry.name == "x")
    spec.x = as_expression<Formula>(entry);
  else if (entry.name == "y")
    spec.y = as_expression<Formula>(entry);
  else if (entry.name == "y_error")
    spec.y_error = as_expression<Formula>(entry);
  else if (entry.name == "x_label")
    spec.x_label = as_string(entry);
  else if (entry.name == "y_label")
    spec.y_label = as_string(entry);
  else if (entry.name == "x_scale")
    spec.x_log = as_one_of(entry, scales) == 1;
  else if (entry.name == "y_scale")
    spec.y_log = as_one_of(entry, scales) == 1;
  else if (entry.name == "title")
    spec.title = as_string(entry);
  else if (entry.name == "series")
    spec.series = as_fields(entry);
  else if (entry.name == "where")
    spec.where = as_expression<Where>(entry);
  else if (entry.name == "mean_over")
    spec.mean_over = as_fields(entry);
  else if (entry.name == "lines")
    spec.lines = as_truth(entry);
  else if (entry.name == "fit")
    spec.fit = read_fit(entry);
  else if (entry.name == "guides")
    spec.guides = read_guides(entry);
  else
    refuse_unknown(entry, plot_keys);
}

PlotSpec read_plot(const Entry& plot, PlotSpec spec) {
  const auto keys = entries(as_table(plot), *plot.file, plot.path);
  spec.kind = kind_of(keys);
  Mistakes mistakes;
  for (const Entry& entry : keys) mistakes.keep([&] { read_key(entry, spec); });
  mistakes.refuse_any();
  require_drawable(spec, plot);
  if (!spec.y_error.empty() && !spec.mean_over.empty())
    refuse(plot, "'y_error' and 'mean_over' conflict: the bars of means are standard deviations");
  require_keys_of(spec.kind, plot);
  return spec;
}

}  // namespace

PlotSpec usual_plot(const Grid& grid) {
  PlotSpec spec;
  if (!std::ranges::all_of(grid.representatives, is_vibrated)) return spec;
  spec.x = "alpha";
  spec.y = "h_cm_excess";
  spec.x_log = false;
  return spec;
}

std::vector<PlotSpec> read_plots(const Entry& plot, const PlotSpec& usual) {
  if (!plot.node->is_array()) return {read_plot(plot, usual)};
  const auto tables = elements(plot);
  if (tables.empty() || tables.size() > max_plots) refuse(plot, fmt::format("1 to {} plots are allowed", max_plots));
  std::vector<PlotSpec> plots;
  std::set<std::string> names;
  Mistakes mistakes;
  const auto read = [&](const Entry& table) {
    plots.push_back(read_plot(table, usual));
    if (names.insert(plots.back().name).second) return;
    refuse(table, plots.back().name.empty() ? "only one plot may be without a name"
                                            : fmt::format("there is another plot '{}'", plots.back().name));
  };
  for (const Entry& table : tables) mistakes.keep([&] { read(table); });
  mistakes.refuse_any();
  const auto main = std::ranges::find(plots, "", &PlotSpec::name);
  if (main != plots.end()) std::rotate(plots.begin(), main, main + 1);
  return plots;
}

}  // namespace sigmasweep::spec
