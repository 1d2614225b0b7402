#pragma once

#include <string>

#include "plot/figure/figure.hpp"
#include "plot/gnuplot/gnuplot.hpp"

namespace sigmasweep::plot {

/// The commands with which gnuplot draws a figure. Text from users goes in single quotes, where it is never more than
/// text.
std::string gnuplot_script(const Figure& figure, Form form);

}  // namespace sigmasweep::plot
