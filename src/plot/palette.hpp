#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace sigmasweep::plot {

/// The colour of the n-th series of a plot, from 0. The colours are those of Okabe and Ito, which people with any kind
/// of colour vision can tell apart. Seven colours and eight symbols make 56 pairs.
constexpr std::string_view series_colour(std::size_t n) {
  constexpr auto colours =
      std::to_array<std::string_view>({"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7F6000"});
  return colours[n % colours.size()];
}

/// The symbol of the n-th series: a point type of gnuplot.
constexpr int series_symbol(std::size_t n) {
  constexpr auto symbols = std::to_array<int>({6, 4, 8, 12, 10, 2, 14, 1});
  return symbols[n % symbols.size()];
}

}  // namespace sigmasweep::plot
