#pragma once

#include <string>

#include "plot/figure/figure.hpp"
#include "plot/gnuplot/gnuplot.hpp"

namespace sigmasweep::plot {

/// The gnuplot script that draws a figure. Text from users stands in single quotes, so that gnuplot never runs it.
std::string gnuplot_script(const Figure& figure, Form form);

}  // namespace sigmasweep::plot
