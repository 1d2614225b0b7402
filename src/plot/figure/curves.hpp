#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "plot/figure/coordinate.hpp"
#include "plot/figure/figure.hpp"

namespace sigmasweep::plot {

/// Sorts rows into curves, and averages those that differ in `mean_over` only.
class Curves {
 public:
  /// `with_hard_line`: soft and hard spheres both occur, and the hard ones are drawn as lines.
  Curves(const PlotSpec& spec, const Coordinate& x, const Coordinate& y, bool with_hard_line);
  /// The curve that the row is part of, by its place.
  std::size_t add(const Row& row, const Point& point);
  std::vector<Curve> take();
  /// "points are means over seed, n = 10"; empty where nothing is averaged. Enhanced text; after take().
  const std::string& note() const { return note_; }

 private:
  /// A point that is the mean of several rows.
  struct Mean {
    std::size_t curve;
    double x;
    std::vector<double> values{};  ///< the y of its rows
  };
  std::size_t curve_of(const Row& row);
  void add_to_mean(std::size_t curve, const Row& row, const Point& point);
  void take_means();

  std::vector<const Field*> series_, line_keys_, mean_over_;
  bool universal_, with_hard_line_, joined_;
  std::map<std::vector<double>, std::size_t> places_;
  std::set<std::string> labels_;
  std::vector<Curve> curves_;

  using Place = std::pair<std::size_t, double>;                          ///< curve and rounded x
  std::map<std::pair<Place, std::vector<double>>, std::uint64_t> seen_;  ///< rows there with these mean_over
  std::map<std::pair<Place, std::uint64_t>, std::size_t> groups_;        ///< n-th of them: means_
  std::vector<Mean> means_;
  std::string note_;
};

}  // namespace sigmasweep::plot
