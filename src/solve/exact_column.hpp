#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "binary_contact.hpp"
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
template <class Real>
class ExactColumn {
 public:
  ExactColumn(const Column<Real>& column, const ExactOptions& options);
  Outcome<Real> run();

 private:
  static constexpr int none = -1;
  using State = ContactState<Real>;

  /// Contacts lo..hi that move together: every closed one, its open neighbours, and whatever shares one of these.
  struct Group {
    std::size_t lo = 0, hi = 0;
    Real start{}, length{};      ///< the present step, in time
    Real scaled{};               ///< Taylor: the step's length over h
    std::size_t contact = 0;     ///< which contact changes at the step's end, if `event`
    bool event = false, binary = false;
    bool prepared = false;       ///< Taylor: the laws are set
    Real longest{};              ///< Taylor: how far the series reaches, in time
    State entry{};               ///< binary: the contact's state at the start
    TaylorGroup<Real> taylor;
  };

  const Real& K(std::size_t k) const { return k == 0 ? column_.K_wall : column_.K; }
  const Real& C(std::size_t k) const { return k == 0 ? column_.C_wall : column_.C; }
  static Real inertia(std::size_t k) { return k == 0 ? Real(1) : Real(2); }
  const BinaryContact<Real>& binary(std::size_t k) const { return k == 0 ? wall_ : pair_; }

  void close_gap(std::size_t k, const Real& t);
  void finish_step(int id);
  void change_contact(std::size_t k, const Real& t);
  void synchronise(std::size_t k, const Real& t);
  void move_group(Group& group, const Real& elapsed, bool whole_step);
  void dissolve(int id, const Real& t);
  void regroup(std::size_t lo, std::size_t hi, const Real& t);
  void make_group(std::size_t lo, std::size_t hi, const Real& t);
  void begin_step(int id);
  bool begin_binary(Group& group);
  void begin_taylor(Group& group);
  void schedule_gap(std::size_t k);
  Real longest_step(const Group& group) const;
  Real disturbed(const Real& value);
  bool settled();
  std::vector<Real> velocities() const;

  Column<Real> column_;
  ExactOptions options_;
  std::size_t N_;
  BinaryContact<Real> wall_, pair_;
  StepLengths<Real> steps_;
  std::vector<Real> x_, u_, at_;        ///< overlap, rate, and the time they are of
  std::vector<std::uint8_t> closed_;
  std::vector<int> group_of_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<int> idle_;               ///< groups free for use
  Tournament<Real> events_;
  std::size_t closed_count_ = 0;
  std::uint64_t contacts_ = 0, checked_at_ = 0, noise_ = 0x9e3779b97f4a7c15u;
  Real wall_opened_{}, x_max_{};
};

}  // namespace sigmasweep
