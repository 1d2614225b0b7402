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

/// The curves of a plot while rows are added. Rows that differ in the fields `mean_over` only are averaged.
class Curves {
 public:
  /// `with_hard_line`: hard spheres are drawn as lines, because soft spheres occur, too.
  Curves(const PlotSpec& spec, const Coordinate& x, const Coordinate& y, bool with_hard_line);
  /// Adds the point of a row and returns the index of its curve.
  std::size_t add(const Row& row, const Point& point);
  /// The finished curves; they can be taken once.
  std::vector<Curve> take();
  /// The note that points are means, in enhanced text: "Means over seed, n = 10, ...". It is empty if nothing is
  /// averaged. To be called after take().
  const std::string& note() const { return note_; }

 private:
  /// A point that is the mean of several rows.
  struct Mean {
    std::size_t curve;
    double x;
    std::vector<double> values{};     ///< y of each row
    std::size_t row = Point::no_row;  ///< the first one
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
  std::map<std::pair<Place, std::vector<double>>, std::uint64_t> seen_;  ///< number of rows at a place, by mean_over
  std::map<std::pair<Place, std::uint64_t>, std::size_t> groups_;        ///< n-th mean at a place: index in means_
  std::vector<Mean> means_;
  std::string note_;
};

}  // namespace sigmasweep::plot
