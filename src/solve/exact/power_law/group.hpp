#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assembly/column.hpp"
#include "assembly/ground.hpp"
#include "contact/contact_forces.hpp"
#include "numerics/dormand_prince.hpp"

namespace sigmasweep {

/// A run of neighbouring contacts, closed ones with the open gaps beside them, moved step by step:
///     x_k'' = F_(k-1)/m_(k-1) - F_k (1/m_(k-1) + 1/m_k) + F_(k+1)/m_k,  F of contact_forces.hpp where k is closed.
/// The independent variable of a step is the time or, while a contact (the leader) is near x = 0, its s = x^(1/q):
///     dt/ds = q s^(q-1)/u,  dx_j/ds = u_j dt/ds,  du_j/ds = a_j dt/ds,
/// with q such that all powers of s in the leader's force are whole: in s it is smooth. See
/// docs/physics/exact-power-law.md.
/// Ground: on a plate its load accelerates contact 0, and the works (PlateWork) are integrated along with the motion.
template <class Real, class Ground = FixedWall>
class PowerLawGroup {
 public:
  PowerLawGroup(const Column<Real>& column, const Real& accuracy, const Ground& ground = {});

  /// The overlap at which a gap counts as closed: so small that the force left out is below the accuracy. Contacts
  /// that touch without approaching close when the others have pushed them together that far.
  static Real closing_overlap(const Real& accuracy) { return accuracy * Real(0.01); }

  /// Contacts lo..hi, which of them are closed, their overlaps and rates.
  void start(std::size_t lo, std::size_t hi, std::span<const std::uint8_t> closed, std::span<const Real> x,
             std::span<const Real> u);

  /// One step from where the group is, at time `begin`; length() and event() say what came out. False if no step is
  /// small enough.
  bool step(const Real& begin);
  /// Where the step just made ends.
  void finish(std::span<Real> x, std::span<Real> u);
  /// At a time within the step just made, counted from its start; the step stays as it is.
  void within(const Real& elapsed, std::span<Real> x, std::span<Real> u);

  const Real& length() const { return length_; }               ///< duration of the step
  std::optional<std::size_t> event() const { return event_; }  ///< which contact changes at its end
  /// Largest overlap of a closed contact in the step just made, if above `known`; else `known`. Before finish().
  Real deepest(const Real& known);
  /// From the step's start to where finish() or within() was asked for last.
  PlateWork plate_work() const requires(Ground::moves) { return done_; }
  std::uint64_t work() const { return work_; }  ///< contacts times trial steps so far

 private:
  /// n overlaps, n rates; in the leader's place the time since the step's start. On a plate its two works after these.
  using State = std::vector<Real>;
  static constexpr std::size_t none = SIZE_MAX;

  struct Crossing {
    std::size_t contact;
    Real fraction;  ///< of the step
  };

  void slopes(const State& y, State& dy, const Real& at);
  Real trial(const Real& span);
  void choose_leader();
  void lead_by(std::size_t contact);
  Real first_guess() const;
  Real shortened(const Real& span, const Real& error) const;
  Real lengthened(const Real& span, const Real& error) const;
  bool should_lead(std::size_t i) const;
  void end_at(std::optional<Crossing> crossing);
  bool leader_reverses() const;
  Real second_slope(const State& y, const State& dy, const Real& at, std::size_t i) const;
  std::array<Real, 6> hermite(std::size_t i) const;
  Real maximum(std::size_t i);
  std::optional<Crossing> first_crossing(std::size_t but) const;
  bool locate(std::size_t i, const Real& fraction);
  Real target(std::size_t i) const { return closed_[i] ? Real(0) : delta_; }
  Real power_of(const Real& s, int n) const;
  Real span_for(const Real& elapsed);
  void read(const State& y, const Real& at, std::span<Real> x, std::span<Real> u);
  void drive(State& dy, const Real* x, const Real* u, const Real& elapsed) requires(Ground::moves);

  const Column<Real>& column_;
  [[no_unique_address]] Ground ground_;
  PlateWork done_;
  Real begin_{};
  ContactForces<Real> force_;
  Real accuracy_, delta_;
  int q_;
  std::size_t lo_ = 0, n_ = 0;
  std::vector<std::uint8_t> closed_;
  std::vector<Real> K_, C_, below_, above_, inertia_, F_;
  std::vector<Real> at_start_;  ///< overlaps, the leader's too
  State scratch_, start_, end_, start_slope_, end_slope_;
  std::size_t leader_ = none, banned_ = none;
  Real from_{}, span_{};  ///< of the independent variable
  Real error_{};          ///< of the last trial, over the accuracy
  Real next_time_span_{}, next_s_span_{};
  Real length_{};
  std::optional<std::size_t> event_;
  std::uint64_t work_ = 0;
  DormandPrince<Real> scheme_;
};

}  // namespace sigmasweep
