#include "sigmasweep/plot/plot.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "plot/gnuplot/script.hpp"

namespace sigmasweep {

std::vector<SeriesFit> plot_rows(std::span<const Row> rows, const PlotSpec& spec, const std::string& title,
                                 const std::string& path) {
  const plot::Form form = plot::form_of(path);
  const plot::Figure figure = plot::figure_of(rows, spec, title);
  plot::run_gnuplot(plot::gnuplot_script(figure, form), path);
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
