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
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

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

constexpr auto fit_keys = std::to_array<Key<FitSpec>>({
    {{"form", KeyForm::choice, "y = A x^b, fitted in the logarithms, or y = a + b x", "power", forms},
     [](const Entry& entry, FitSpec& fit) { fit.form = static_cast<FitSpec::Form>(as_one_of(entry, forms)); }},
    {{"from", KeyForm::number, "points from this x on are fitted", "all"},
     [](const Entry& entry, FitSpec& fit) { fit.from = as_finite(entry); }},
    {{"to", KeyForm::number, "points up to this x are fitted", "all"},
     [](const Entry& entry, FitSpec& fit) { fit.to = as_finite(entry); }},
});

FitSpec read_fit(const Entry& table) {
  FitSpec fit;
  read_keys(table, fit_keys, fit);
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

struct Guide {
  GuideSpec spec;
  bool sloped = false;
};

constexpr auto guide_keys = std::to_array<Key<Guide>>({
    {{"slope", KeyForm::number, "of a straight line; on two logarithmic axes that of log y against log x"},
     [](const Entry& entry, Guide& guide) { guide.spec.slope = as_finite(entry), guide.sloped = true; }},
    {{.name = "y",
      .form = KeyForm::expression,
      .meaning = "a horizontal line at this y, or a curve, y as a function of x",
      .also_number = true},
     [](const Entry& entry, Guide& guide) {
       if (entry.node->is_string())
         guide.spec.curve = as_function(entry);
       else
         guide.spec.y = as_finite(entry);
     }},
    {{"label", KeyForm::text, "its name in the key", "none"},
     [](const Entry& entry, Guide& guide) { guide.spec.label = as_string(entry); }},
    {{"through", KeyForm::point, "a point [x, y] of a line with a slope", "the last one of the data"},
     [](const Entry& entry, Guide& guide) { guide.spec.through = as_point(entry); }},
    {{"where", KeyForm::condition, "rows whose last point the line goes through", "all"},
     [](const Entry& entry, Guide& guide) { guide.spec.where = as_expression<Where>(entry); }},
    {{"from", KeyForm::number, "the line begins at this x", "at the edge"},
     [](const Entry& entry, Guide& guide) { guide.spec.from = as_finite(entry); }},
    {{"to", KeyForm::number, "the line ends at this x", "at the edge"},
     [](const Entry& entry, Guide& guide) { guide.spec.to = as_finite(entry); }},
});

GuideSpec read_guide(const Entry& table) {
  Guide read;
  read_keys(table, guide_keys, read);
  const auto& [guide, sloped] = read;
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

void read_x(const Entry& entry, PlotSpec& plot) {
  if (plot.kind == PlotKind::trajectories)
    plot.by_phase = as_one_of(entry, film_axes) == 1;
  else
    plot.x = as_expression<Formula>(entry);
}

/// The kind is read before all other keys.
constexpr auto plot_keys = std::to_array<Key<PlotSpec>>({
    {{"name", KeyForm::text, "letters, digits, - and _, for the file of one of several plots", "none"},
     [](const Entry& entry, PlotSpec& plot) { plot.name = as_name(entry); }},
    {{"kind", KeyForm::choice, "rows as points, trajectories as panels, or which time steps are stable", "points",
      kinds},
     [](const Entry&, PlotSpec&) {}},
    {{"x", KeyForm::expression, "field or expression; of trajectories 'time' or 'phase'", "sigma; vibrated: alpha"},
     read_x},
    {{"y", KeyForm::expression, "field or expression", "eps_eff; vibrated: h_cm_excess"},
     [](const Entry& entry, PlotSpec& plot) { plot.y = as_expression<Formula>(entry); }},
    {{"x_label", KeyForm::text, "label of the axis", "made from x"},
     [](const Entry& entry, PlotSpec& plot) { plot.x_label = as_string(entry); }},
    {{"y_label", KeyForm::text, "label of the axis", "made from y"},
     [](const Entry& entry, PlotSpec& plot) { plot.y_label = as_string(entry); }},
    {{"x_scale", KeyForm::choice, "scale of the axis", "log; vibrated: linear", scales},
     [](const Entry& entry, PlotSpec& plot) { plot.x_log = as_one_of(entry, scales) == 1; }},
    {{"y_scale", KeyForm::choice, "scale of the axis", "linear", scales},
     [](const Entry& entry, PlotSpec& plot) { plot.y_log = as_one_of(entry, scales) == 1; }},
    {{"series", KeyForm::fields, "fields: a curve for each combination of their values", "one curve"},
     [](const Entry& entry, PlotSpec& plot) { plot.series = as_fields(entry); }},
    {{"title", KeyForm::text, "above the picture", "the spec's"},
     [](const Entry& entry, PlotSpec& plot) { plot.title = as_string(entry); }},
    {{"where", KeyForm::condition, "condition on the rows that are drawn", "all rows"},
     [](const Entry& entry, PlotSpec& plot) { plot.where = as_expression<Where>(entry); }},
    {{"mean_over", KeyForm::fields, "rows that differ in these fields only are averaged", "none"},
     [](const Entry& entry, PlotSpec& plot) { plot.mean_over = as_fields(entry); }},
    {{"lines", KeyForm::truth, "whether the points of a curve are joined", "false"},
     [](const Entry& entry, PlotSpec& plot) { plot.lines = as_truth(entry); }},
    {{.name = "fit",
      .form = KeyForm::table,
      .meaning = "a line fitted to each curve by least squares",
      .usual = "none",
      .keys = [] { return infos_of(fit_keys); }},
     [](const Entry& entry, PlotSpec& plot) { plot.fit = read_fit(entry); }},
    {{.name = "guides",
      .form = KeyForm::tables,
      .meaning = "dashed lines to compare with",
      .usual = "none",
      .keys = [] { return infos_of(guide_keys); }},
     [](const Entry& entry, PlotSpec& plot) { plot.guides = read_guides(entry); }},
    {{"y_error", KeyForm::expression, "field or expression of error bars", "h_cm_error of h_cm and h_cm_excess"},
     [](const Entry& entry, PlotSpec& plot) { plot.y_error = as_expression<Formula>(entry); }},
});

PlotSpec read_plot(const Entry& plot, PlotSpec spec) {
  spec.kind = kind_of(entries(as_table(plot), *plot.file, plot.path));
  read_keys(plot, plot_keys, spec);
  require_drawable(spec, plot);
  if (!spec.y_error.empty() && !spec.mean_over.empty())
    refuse(plot, "'y_error' and 'mean_over' conflict: the bars of means are standard deviations");
  require_keys_of(spec.kind, plot);
  return spec;
}

}  // namespace

PlotSpec usual_plot(const std::vector<Parameters>& representatives) {
  PlotSpec spec;
  if (!std::ranges::all_of(representatives, is_vibrated)) return spec;
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

std::vector<KeyInfo> keys_of_plot() { return infos_of(plot_keys); }

}  // namespace sigmasweep::spec
