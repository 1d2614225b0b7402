#include "solve/exact/linear/side_by_side/batch.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>

#include "contact/linear_pair.hpp"
#include "solve/exact/linear/side_by_side/advance.hpp"
#include "solve/exact/linear/side_by_side/lane.hpp"

namespace sigmasweep {
namespace {

using namespace side_by_side;

/// Tuples with equal N pass through W lanes: when one has come to an end the next takes its lane.
template <int W>
class Batch {
 public:
  Batch(std::span<const Parameters> parameters, std::span<SimulationResult> results)
      : parameters_(parameters), results_(results), columns_(std::make_unique<Columns<W>>()) {
    columns_->N = static_cast<int>(parameters[0].N);
    for (int l = 0; l < W; ++l) refill(l);
  }

  void run() {
    while (busy_ > 0) {
      for (int l = 0; l < W; ++l)
        if (lanes_[l]) columns_->noise[l] = lanes_[l]->noise();
      advance(*columns_);
      for (int l = 0; l < W; ++l) {
        if (!lanes_[l] || !(columns_->separated[l] || lanes_[l]->is_due(columns_->contacts[l]))) continue;
        const LaneState state = taken_from(l);
        if (!lanes_[l]->ends(state)) continue;
        results_[tuple_[l]] = lanes_[l]->result(state);
        lanes_[l].reset();
        --busy_;
        refill(l);
      }
    }
  }

 private:
  void refill(int l) {
    columns_->active[l] = 0;
    columns_->separated[l] = 0;
    if (next_ == parameters_.size()) return;
    tuple_[l] = next_++;
    lanes_[l].emplace(parameters_[tuple_[l]]);
    ++busy_;
    Columns<W>& c = *columns_;
    c.active[l] = -1;
    c.spring[l] = lanes_[l]->spring();
    c.dashpot[l] = lanes_[l]->dashpot();
    c.wall_spring[l] = lanes_[l]->wall_spring();
    c.wall_dashpot[l] = lanes_[l]->wall_dashpot();
    c.clock[l] = c.wall_opened[l] = c.x_max[l] = 0.0;
    c.contacts[l] = 0;
    const LaneState start = lanes_[l]->start();
    for (int k = 0; k < c.N; ++k) {
      c.x[k][l] = start.x[k];
      c.u[k][l] = start.u[k];
      c.dx[k][l] = start.dx[k];
      c.du[k][l] = start.du[k];
      c.closed[k][l] = start.closed[k] ? -1 : 0;
    }
  }

  LaneState taken_from(int l) const {
    const Columns<W>& c = *columns_;
    LaneState s;
    for (int k = 0; k < c.N; ++k) {
      s.x[k] = c.x[k][l];
      s.u[k] = c.u[k][l];
      s.dx[k] = c.dx[k][l];
      s.du[k] = c.du[k][l];
      s.closed[k] = c.closed[k][l] != 0;
    }
    s.clock = c.clock[l];
    s.wall_opened = c.wall_opened[l];
    s.x_max = c.x_max[l];
    s.contacts = c.contacts[l];
    s.separated = c.separated[l] != 0;
    return s;
  }

  std::span<const Parameters> parameters_;
  std::span<SimulationResult> results_;
  std::unique_ptr<Columns<W>> columns_;
  std::array<std::optional<Lane>, W> lanes_;
  std::array<std::size_t, W> tuple_{};
  std::size_t next_ = 0;
  int busy_ = 0;
};

template <int W>
void run_all(std::span<const Parameters> parameters, std::span<SimulationResult> results) {
  for (std::size_t first = 0, end = 0; first < parameters.size(); first = end) {
    while (end < parameters.size() && parameters[end].N == parameters[first].N) ++end;
    Batch<W>(parameters.subspan(first, end - first), results.subspan(first, end - first)).run();
  }
}

}  // namespace

bool goes_side_by_side(const Parameters& p) {
  if (p.N > most_beads || p.width != 0.0) return false;
  const Column<double> column = reduced_column<double>(p);
  return BinaryContact<double>(column.K, column.C, 2.0).oscillates() &&
         BinaryContact<double>(column.K_wall, column.C_wall, 1.0).oscillates();
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
