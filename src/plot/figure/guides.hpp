#pragma once

#include <optional>
#include <vector>

#include "plot/figure/figure.hpp"
#include "sweep/expression/formula.hpp"
#include "sweep/expression/where.hpp"

namespace sigmasweep::plot {

/// Follows the rows drawn to find where the guides are anchored.
class Guides {
 public:
  explicit Guides(const PlotSpec& spec);
  /// A row that is drawn at `x` in this curve.
  void see(const Row& row, std::size_t curve, double x);
  /// The guides over the figure's ranges; those without any anchor are left out.
  std::vector<Guide> take(const Figure& figure) const;

 private:
  struct Anchored {
    GuideSpec spec;
    std::optional<Where> where;
    std::optional<std::pair<std::size_t, double>> last;  ///< curve and x
  };
  std::vector<Anchored> guides_;
};

}  // namespace sigmasweep::plot
