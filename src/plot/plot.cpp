#include "sigmasweep/plot/plot.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/atomic_file.hpp"
#include "plot/gnuplot/script.hpp"
#include "plot/html/page.hpp"
#include "plot/points.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

/// Whether the name asks for text.
bool is_text(const std::string& path) {
  return path.ends_with(".html") || path.ends_with(".gp") || path.ends_with(".csv");
}

/// The figure as text, where the name asks for that: a page of HTML, gnuplot's commands with their data, or the points.
std::optional<std::string> text_of(const plot::Figure& figure, std::span<const Row> rows, const PlotSpec& spec,
                                   const std::string& path) {
  if (path.ends_with(".html")) return plot::html_page(figure, rows, spec);
  if (path.ends_with(".gp")) return plot::gnuplot_script(figure, plot::Form::svg);
  if (path.ends_with(".csv")) return plot::points_as_csv(figure, rows, spec);
  return std::nullopt;
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
  if (!is_text(path)) plot::form_of(path);
  const plot::Figure figure = plot::figure_of(rows, spec, title);
  if (const auto text = text_of(figure, rows, spec, path))
    write_text(path, *text);
  else
    plot::run_gnuplot(plot::gnuplot_script(figure, plot::form_of(path)), path);
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
