#pragma once

#include <optional>
#include <vector>

#include "plot/figure/figure.hpp"
#include "sweep/expression/formula.hpp"
#include "sweep/expression/where.hpp"

namespace sigmasweep::plot {

/// The guides of a plot. A guide with a slope passes through the last point of the rows that it is anchored to.
class Guides {
 public:
  explicit Guides(const PlotSpec& spec);
  /// Adds a row that is drawn at `x` on the curve with this index.
  void add(const Row& row, std::size_t curve, double x);
  /// The guides within the figure's ranges. A guide without a point to pass through is left out.
  std::vector<Guide> lines(const Figure& figure) const;

 private:
  struct Anchored {
    GuideSpec spec;
    std::optional<Where> where;
    std::optional<std::pair<std::size_t, double>> last;  ///< curve and x of the point with the largest x
  };
  std::vector<Anchored> guides_;
};

}  // namespace sigmasweep::plot
