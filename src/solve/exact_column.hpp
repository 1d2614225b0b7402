#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "contact_laws.hpp"
#include "energy_balance.hpp"
#include "noise.hpp"
#include "samples.hpp"
#include "sigmasweep/solve/column.hpp"
#include "sigmasweep/solve/exact.hpp"
#include "step_lengths.hpp"
#include "taylor_group.hpp"
#include "tournament.hpp"

namespace sigmasweep {

/// One collision, from contact event to contact event. Contacts are numbered 0 (the wall) to N-1 here. The state is the
/// overlaps x and their rates u = x', not positions: an overlap of 1e-12 keeps all its digits whatever the column's
/// length. Beads without a closed contact fly freely: their gaps are brought up to date only when somebody asks. Each
/// group of closed contacts, with the open gaps beside them, runs on its own clock from step to step; whichever group
/// or gap has the earliest event is next.
///
/// Beside the column's own motion run `Disturbances` linearised ones: what rounding puts into the state, drawn at random
/// step by step and carried along by the same linear maps and by the jumps at the events. They measure how much of the
/// rounding error survives to the end.
///
/// Order: of the Taylor series. Where it is low what they leave out takes the place of rounding.
///
/// Uneven: the beads have masses of their own (column.mass). Gaps that differ need no such feature.
template <class Real, int Disturbances, bool Uneven, int Order = TaylorOrder<Real>::value>
class ExactColumn {
 public:
  ExactColumn(const Column<Real>& column, const ExactOptions& options);
  /// Before run(): all contacts open, gaps as in the column (the wall's, too), and these closing speeds. Time 0 is now.
  void start_from(std::span<const Real> rates);
  Outcome<Real> run();
  /// The same, seen by a watcher (samples.hpp), and over with its last sample. Samples: double without disturbances.
  template <class Watcher>
  Outcome<Real> run(Watcher& watcher);
  /// After run(): a bound of the error of eps_eff, `safety` times the disturbances' size.
  Real error(double safety) const;
  /// After run(): the largest change of eps_eff by a disturbance.
  Real disturbance() const { return balance().disturbance; }
  /// What a step adds to the error, relative to the state.
  static Real local_error() { return std::max(std::numeric_limits<Real>::epsilon(), Taylor::left_out()); }
  /// Contacts propagated, summed over all Taylor steps: what a run in a wider type would cost.
  std::uint64_t work() const { return work_; }

 private:
  static constexpr int none = -1;
  static constexpr double longest_clock = 16.0;  ///< t_c
  static constexpr int motions = 1 + Disturbances;
  using State = ContactState<Real>;
  using Taylor = TaylorGroup<Real, motions, Uneven, Order>;

  /// Overlaps and rates of all contacts: [0] the column's own, then the disturbances'.
  struct Motion {
    std::vector<Real> x, u;
  };

  /// Contacts lo..hi that move together: every closed one, its open neighbours, and whatever shares one of these.
  struct Group {
    std::size_t lo = 0, hi = 0;
    Real start{}, length{};      ///< the present step, in time
    std::size_t contact = 0;     ///< which contact changes at the step's end, if `event`
    bool event = false, binary = false;
    bool prepared = false;       ///< Taylor: the laws are set
    Real longest{};              ///< Taylor: how far the series reaches, in time
    Real scaled{};               ///< Taylor: length over longest
    Taylor taylor;
  };
  struct Range {
    std::size_t lo, hi;
  };

  /// Where eps_eff stands at a moment within the collision.
  struct Balance {
    Real disturbance{};  ///< largest change of sqrt(E/E_0), E kinetic plus elastic, by a disturbance
    Real remaining{};    ///< at most this can sqrt(E/E_0) still fall
  };

  State state(std::size_t k) const { return {x_[k], u_[k]}; }

  void disturb_gaps();
  void begin_anew(const Real& t);
  void close_gap(std::size_t k, const Real& t);
  void finish_step(int id);
  void change_contact(std::size_t k, const Real& t);
  Range release(std::size_t k, const Real& t);
  void move_group(Group& group, const Real& elapsed, bool whole_step);
  void move_taylor(Group& group, const Real& elapsed, bool whole_step);
  void move_binary(Group& group, const Real& elapsed, bool whole_step);
  void disturb(std::size_t i, const State& magnitude);
  void dissolve(int id, const Real& t);
  void regroup(Range range, const Real& t);
  void make_group(Range range, const Real& t);
  void begin_step(int id);
  bool begin_binary(Group& group);
  void begin_taylor(Group& group);
  void schedule_gap(std::size_t k);
  Balance balance() const;
  bool settled(std::uint64_t step);
  std::vector<Real> velocities(int motion) const;
  void state_at(const Real& t, std::span<Real> x, std::span<Real> u) const;

  Column<Real> column_;
  ExactOptions options_;
  std::size_t N_;
  ContactLaws<Real, Uneven> laws_;
  StepLengths<Real, Uneven> steps_;
  std::array<Motion, motions> motion_;
  std::vector<Real>&x_, &u_;            ///< of the column's own motion
  Real epoch_{};                        ///< when the clock was last set to 0, since the start
  std::vector<Real> at_;                ///< free gaps: the time their state is of
  std::vector<std::uint8_t> closed_;
  std::vector<int> group_of_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<int> idle_;               ///< groups free for use
  Tournament<Real> events_;
  Noise noise_;
  std::size_t closed_count_ = 0;
  std::uint64_t contacts_ = 0, checked_at_ = 0, checked_step_ = 0, work_ = 0;
  Real wall_opened_{}, x_max_{};
  std::vector<Balance> balances_;       ///< those that could give the smallest error
};

}  // namespace sigmasweep
