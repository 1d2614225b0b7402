#include "solve/exact/linear/side_by_side/lanes/uncertain.hpp"

#include <algorithm>

#include "numerics/first_root.hpp"
#include "solve/exact/linear/side_by_side/lanes/series.hpp"

namespace sigmasweep::side_by_side {

FirstEvent first_event_of_lane(const double* a, const long long* closed, const long long* suspect, int stride, int N) {
  using Roots = FirstRoot<double, order>;
  FirstEvent first{1.0, -1};
  for (int k = 0; k < N && first.when > 0.0; ++k) {
    if (!suspect[k * stride]) continue;
    const double sign = closed[k * stride] ? 1.0 : -1.0;
    Roots::Coefficients distance;
    for (int p = 0; p <= order; ++p)
      distance[std::size_t(p)] = sign * a[(p * most_beads + k) * stride] * one_over.of_factorial[p];
    distance[0] = std::max(distance[0], 0.0);
    if (const auto when = Roots::find(distance, first.when)) first = {*when, k};
  }
  return first;
}

}  // namespace sigmasweep::side_by_side
