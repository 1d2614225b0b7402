#pragma once

#include <span>
#include <string>
#include <string_view>

#include "studies/advice/advice.hpp"

namespace sigmasweep {

/// The lines of an input of another code that make the same contacts, in SI units, between beads and with a wall, with
/// a time step.
struct Deck {
  std::string_view code;
  std::string_view remark;  ///< what is different there; empty: nothing
  std::string (*lines)(const Advice& advice, double time_step);
};

/// For LAMMPS, LIGGGHTS, Yade and MercuryDPM.
std::span<const Deck> decks();

}  // namespace sigmasweep
