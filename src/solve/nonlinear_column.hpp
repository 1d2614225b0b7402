#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "energy_balance.hpp"
#include "power_law_group.hpp"
#include "samples.hpp"
#include "sigmasweep/solve/column.hpp"
#include "sigmasweep/solve/nonlinear.hpp"
#include "tournament.hpp"

namespace sigmasweep {

/// One collision under a law that is not linear, from contact event to contact event, in reduced units. As in
/// ExactColumn the state is the overlaps x and their rates u; beads without a closed contact fly freely, each group of
/// closed contacts with the open gaps beside them runs on its own clock, and whatever has the earliest event is next.
template <class Real>
class NonlinearColumn {
 public:
  NonlinearColumn(const Column<Real>& column, const NonlinearOptions& options);
  Outcome<Real> run();
  /// The same, seen by a watcher (samples.hpp), and over with its last sample. Samples: double.
  template <class Watcher>
  Outcome<Real> run(Watcher& watcher);

 private:
  static constexpr int none = -1;
  struct Group {
    Group(const Column<Real>& column, const Real& accuracy) : contacts(column, accuracy) {}
    std::size_t lo = 0, hi = 0;
    Real start{};
    PowerLawGroup<Real> contacts;
  };
  struct Range {
    std::size_t lo, hi;
  };

  void advance(std::size_t next, const Real& t);
  void close_gap(std::size_t k, const Real& t);
  void finish_step(int id);
  void change_contact(std::size_t k, const Real& t);
  Range release(std::size_t k, const Real& t);
  void dissolve(int id, const Real& t);
  void regroup(Range range, const Real& t);
  void make_group(Range range, const Real& t);
  void begin_step(int id);
  void schedule_gap(std::size_t k);
  bool is_settled();
  void state_at(const Real& t, std::span<Real> x, std::span<Real> u);
  std::vector<Real> velocities() const;

  const Column<Real> column_;
  NonlinearOptions options_;
  std::size_t N_;
  Real closing_overlap_;
  std::vector<Real> x_, u_;
  std::vector<Real> at_;  ///< free gaps: the time their state is of
  std::vector<std::uint8_t> closed_;
  std::vector<int> group_of_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<int> idle_;
  Tournament<Real> events_;
  std::uint64_t contacts_ = 0, steps_ = 0, next_check_ = 0, next_check_step_ = 0, work_ = 0;
  bool lost_ = false;  ///< a step that no length makes good
  Real wall_opened_{}, x_max_{};
};

}  // namespace sigmasweep
