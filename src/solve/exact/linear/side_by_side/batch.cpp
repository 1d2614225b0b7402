#include "solve/exact/linear/side_by_side/batch.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/linear_pair.hpp"
#include "solve/exact/linear/side_by_side/lanes/advance.hpp"
#include "solve/exact/linear/side_by_side/lanes/jump.hpp"
#include "solve/exact/linear/side_by_side/packs.hpp"

namespace sigmasweep {
namespace {

using namespace side_by_side;

/// Tuples with equal N pass through two packs of lanes: one that goes by jumps from contact to contact, for columns in
/// which nothing disturbs a closed contact, and one that goes by steps. Queues before them keep both full.
template <int W, bool HasUnequalMasses>
class Batch {
 public:
  Batch(std::span<const Parameters> parameters, std::span<SimulationResult> results,
        std::span<const std::size_t> places)
      : parameters_(parameters),
        results_(results),
        places_(places),
        jumps_(static_cast<int>(parameters[places[0]].N)),
        steps_(static_cast<int>(parameters[places[0]].N)) {}

  void run() {
    for (;;) {
      while (next_ < places_.size() && (jumps_.present() < W && steps_.present() < W)) begin(places_[next_++]);
      if (steps_.present() >= W || jumps_.present() == 0) {
        if (steps_.present() == 0) return;
        go_by_steps();
      } else {
        go_by_jumps();
      }
    }
  }

 private:
  void begin(std::size_t place) {
    Lane lane(parameters_[place]);
    const LaneState state = lane.start();
    const bool by_jumps = lane.starts_by_jumps();
    auto traveller = std::make_unique<Traveller>(Traveller{place, std::move(lane), state});
    by_jumps ? jumps_.add(std::move(traveller)) : steps_.add(std::move(traveller));
  }

  void go_by_jumps() {
    jumps_.prepare();
    jump(jumps_.block());
    for (int l = 0; l < W; ++l) {
      Traveller* const traveller = jumps_.in_lane(l);
      if (!traveller) continue;
      const bool crowded = jumps_.block().crowded[l] != 0;
      if (!crowded && !jumps_.block().separated[l] && !jumps_.wants_look(l)) continue;
      LaneState state = jumps_.state(l);
      traveller->lane.isolated().to_steps(state);
      if (traveller->lane.ends(state)) {
        finish(*jumps_.leave(l), state);
      } else if (crowded) {
        traveller->state = state;
        steps_.add(jumps_.leave(l));
      }
    }
  }

  void go_by_steps() {
    steps_.prepare();
    advance(steps_.block());
    for (int l = 0; l < W; ++l) {
      Traveller* const traveller = steps_.in_lane(l);
      if (!traveller) continue;
      const bool may_jump = steps_.block().event[l] >= 0 && steps_.may_jump(l);
      if (!may_jump && !steps_.block().separated[l] && !steps_.wants_look(l)) continue;
      LaneState state = steps_.state(l);
      if (traveller->lane.ends(state)) {
        finish(*steps_.leave(l), state);
      } else if (may_jump && traveller->lane.isolated().to_jumps(state)) {
        traveller->state = state;
        jumps_.add(steps_.leave(l));
      }
    }
  }

  void finish(Traveller& traveller, const LaneState& state) {
    results_[traveller.place] = traveller.lane.result(state);
  }

  std::span<const Parameters> parameters_;
  std::span<SimulationResult> results_;
  std::span<const std::size_t>
      places_;  ///< the tuples with this N, equal masses or not, in the order in which they are computed
  LanePack<W, HasUnequalMasses, Jumps> jumps_;
  LanePack<W, HasUnequalMasses, Columns> steps_;
  std::size_t next_ = 0;
};

/// Like tuples beside each other take like numbers of steps, of like kinds.
std::vector<std::size_t> sorted_places(std::span<const Parameters> parameters) {
  std::vector<std::size_t> places(parameters.size());
  std::iota(places.begin(), places.end(), std::size_t(0));
  std::ranges::stable_sort(places, {}, [&](std::size_t i) {
    const Parameters& p = parameters[i];
    return std::tuple(p.N, p.width != 0.0, p.sigma, p.epsilon);
  });
  return places;
}

template <int W>
void run_all(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  const std::vector<std::size_t> places = sorted_places(parameters);
  const auto go_together = [&](std::size_t i, std::size_t j) {
    const Parameters &p = parameters[places[i]], &q = parameters[places[j]];
    return p.N == q.N && (p.width != 0.0) == (q.width != 0.0);
  };
  for (std::size_t first = 0, end = 0; first < places.size(); first = end) {
    while (end < places.size() && go_together(first, end)) ++end;
    const auto together = std::span(places).subspan(first, end - first);
    if (parameters[places[first]].width == 0.0)
      Batch<W, false>(parameters, results, together).run();
    else
      Batch<W, true>(parameters, results, together).run();
  }
}

bool all_oscillate(const Column<double>& column) {
  for (std::size_t k = 0; k < column.contacts(); ++k)
    if (!BinaryContact<double>(column.spring(k), column.dashpot(k), column.inertia(k)).oscillates()) return false;
  return true;
}

}  // namespace

bool goes_side_by_side(const Parameters& p) {
  if (p.N > most_beads) return false;
  if (p.width == 0.0 && p.K_over_m == 0.0 && p.epsilon > 1e-13)
    return true;  // 1 - (mu/omega0)^2 > 0.01, more at the wall
  return all_oscillate(reduced_column<double>(p));
}

void simulate_side_by_side(std::span<const Parameters> parameters, std::span<SimulationResult> results, int lanes) {
  if (parameters.size() != results.size()) throw std::invalid_argument("simulate_side_by_side: one result a tuple");
  switch (lanes == 0 ? widest() : lanes) {
    case 1: return run_all<1>(parameters, results);
    case 4: return run_all<4>(parameters, results);
    case 8: return run_all<8>(parameters, results);
    default: throw std::invalid_argument("simulate_side_by_side: 1, 4 or 8 lanes");
  }
}

}  // namespace sigmasweep
