#include "sigmasweep/plot/plot.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/atomic_file.hpp"
#include "plot/gnuplot/script.hpp"
#include "plot/html/page.hpp"
#include "plot/points.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

using Text = std::string (*)(const plot::Figure& figure, std::span<const Row> rows, const PlotSpec& spec);

std::string commands_of(const plot::Figure& figure, std::span<const Row>, const PlotSpec&) {
  return plot::gnuplot_script(figure, plot::Form::svg);
}

/// What writes a figure as text, where the ending of the name asks for that; null where it does not.
Text text_for(const std::string& path) {
  constexpr std::array<std::pair<std::string_view, Text>, 3> forms{
      {{".html", plot::html_page}, {".gp", commands_of}, {".csv", plot::points_as_csv}}};
  const auto form = std::ranges::find_if(forms, [&](const auto& known) { return path.ends_with(known.first); });
  return form == forms.end() ? nullptr : form->second;
}

void write_text(const std::string& path, const std::string& text) {
  AtomicFile file(path, fmt::format(".part{}", ::getpid()));
  if (const int why = write_all(file.fd(), std::as_bytes(std::span(text))); why != 0)
    throw OutputError(fmt::format("cannot write {}: {}", path, reason(why)));
  file.publish();
}

}  // namespace

std::vector<SeriesFit> plot_rows(std::span<const Row> rows, const PlotSpec& spec, const std::string& title,
                                 const std::string& path) {
  const Text text = text_for(path);
  const auto form = text ? std::nullopt : std::optional(plot::form_of(path));  // before the work
  const plot::Figure figure = plot::figure_of(rows, spec, title);
  if (form)
    plot::run_gnuplot(plot::gnuplot_script(figure, *form), path);
  else
    write_text(path, text(figure, rows, spec));
  std::vector<SeriesFit> fits;
  for (const plot::Curve& curve : figure.curves)
    if (curve.fit)
      fits.push_back({curve.name, curve.fit->slope, curve.fit->slope_error, curve.fit->prefactor, curve.fit->points});
  return fits;
}

std::string fit_table(std::span<const SeriesFit> fits, const FitSpec& spec) {
  if (fits.empty()) return {};
  std::size_t width = 6;
  for (const SeriesFit& fit : fits) width = std::max(width, fit.series.size());
  std::string text = fmt::format("  {:<{}}  {:>12}  {:>9}  {:>12}  {:>6}\n", "series", width, "slope", "error",
                                 spec.form == FitSpec::Form::power ? "prefactor" : "intercept", "points");
  for (const SeriesFit& fit : fits)
    text += fmt::format("  {:<{}}  {:>12.6g}  {:>9}  {:>12.6g}  {:>6}\n", fit.series, width, fit.slope,
                        std::isnan(fit.slope_error) ? "-" : fmt::format("{:.2g}", fit.slope_error), fit.prefactor,
                        fit.points);
  return text;
}

}  // namespace sigmasweep
