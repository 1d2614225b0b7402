#include "sigmasweep/report/plot.hpp"

#include "plot_gnuplot.hpp"

namespace sigmasweep {

void plot_rows(std::span<const Row> rows, const PlotSpec& spec, const std::string& title, const std::string& path) {
  const plot::Form form = plot::form_of(path);
  plot::run_gnuplot(plot::gnuplot_script(plot::figure_of(rows, spec, title), form), path);
}

}  // namespace sigmasweep
