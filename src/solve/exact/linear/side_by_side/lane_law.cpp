#include "solve/exact/linear/side_by_side/lane_law.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "solve/exact/linear/step_lengths.hpp"

namespace sigmasweep::side_by_side {
namespace {

double longest_step(const Column<double>& column) {
  const std::vector<std::uint8_t> closed(column.contacts(), 1);
  const std::size_t last = column.contacts() - 1;
  return column.is_uniform() ? StepLengths<double, false>(column).longest(0, last, closed)
                             : StepLengths<double, true>(column).longest(0, last, closed);
}

LaneLaw made_for(const Parameters& p) {
  const Column<double> column = reduced_column<double>(p);
  const double h = longest_step(column);
  return {.step = h,
          .spring = column.K * h * h,
          .wall_spring = column.K_wall * h * h,
          .isolated = Isolated(reduced_column<long double>(p), h)};
}

}  // namespace

std::shared_ptr<const LaneLaw> law_of(const Parameters& p) {
  if (p.width != 0.0) return std::make_shared<const LaneLaw>(made_for(p));
  using Key = std::tuple<std::int64_t, double, double, double, double, Wall>;
  constexpr std::size_t most = 16;
  thread_local std::vector<std::pair<Key, std::shared_ptr<const LaneLaw>>> known;
  thread_local std::size_t oldest = 0;
  const bool by_stiffness = p.K_over_m > 0.0;
  const Key key{p.N, p.epsilon, p.K_over_m, p.D_n, by_stiffness ? p.tc : 0.0, p.wall};
  const auto found = std::ranges::find(known, key, [](const auto& entry) { return entry.first; });
  if (found != known.end()) return found->second;
  auto law = std::make_shared<const LaneLaw>(made_for(p));
  if (known.size() < most)
    known.emplace_back(key, law);
  else
    known[oldest++ % most] = {key, law};
  return law;
}

}  // namespace sigmasweep::side_by_side
