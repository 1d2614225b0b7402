#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "assembly/column.hpp"
#include "contact/collision_table.hpp"
#include "contact/contact_state.hpp"
#include "solve/exact/power_law/group.hpp"

namespace sigmasweep {

/// Contacts that open again before anything else happens to their beads: isolated ones. Such a contact has its outcome
/// from a table, and its column is written as if that had come at the closing: with the virtual state (eps u D, -eps u)
/// the contact flies uniformly to x = 0, where it opens after the contact's duration D, and the gaps beside it fly
/// uniformly, too. See docs/physics/exact-power-law.md.
class IsolatedContacts {
 public:
  /// `accuracy`: local error of a step. `restitution_off`: part by which restitutions are made smaller, of a twin run.
  IsolatedContacts(const Column<double>& column, double accuracy, double restitution_off);

  /// Whether contact k is closed and in its virtual state.
  bool is_busy(std::size_t k) const { return busy_[k] != 0; }
  bool any() const { return count_ > 0; }

  /// A lower bound of how long a collision of contact k lasts without losses: to the largest overlap and back at speed
  /// u.
  double least_duration(std::size_t k, double u) const;
  /// The virtual state of contact k, which closes, if it may be isolated as far as its own collision is concerned.
  std::optional<ContactState<double>> virtual_state(std::size_t k, const ContactState<double>& closing);
  /// Contact k gets the virtual state that virtual_state() has just returned.
  void begin(std::size_t k, const ContactState<double>& closing, double t);
  /// It opens, or is not isolated any more. Its largest overlap is returned.
  double end(std::size_t k);
  /// The true state of a busy contact at time t.
  ContactState<double> true_state(std::size_t k, double t);

  /// Part of the relative acceleration of contact k that the contact beside it feels, with the other sign: that of the
  /// bead between them. So it gets that part of every difference between k's states.
  double share(std::size_t k, std::size_t beside) const;

 private:
  struct Collision {
    ContactState<double> closing;
    double begun, x_max;
  };

  const Column<double>& column_;
  PairLaw law(std::size_t k) const;

  double accuracy_, restitution_off_, x_max_ = 0.0;
  std::optional<std::shared_ptr<const CollisionTable>> table_;  ///< once it has been asked for
  std::vector<Collision> collision_;                            ///< of busy contacts
  std::vector<std::uint8_t> busy_, closed_;
  std::vector<double> x_, u_;  ///< scratch, as closed_
  PowerLawGroup<double> alone_;
  std::size_t count_ = 0;
};

}  // namespace sigmasweep
