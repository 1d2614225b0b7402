#pragma once

#include <array>

#include "model/fields/conditions.hpp"
#include "model/fields/member.hpp"

/// The tables of results and timings, in the order in which they are stored and shown.
namespace sigmasweep {

inline constexpr auto table_of_results = std::to_array<FieldOf<SimulationResult>>({
    {SIGMASWEEP_MEMBER(SimulationResult, eps_eff), .unit = "1", .meaning = "effective restitution sqrt(E_f/E_0)",
     .symbol = "{/:Italic ε}_{eff}", .quantity = "effective restitution {/:Italic ε}_{eff}",
     .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, eps_eff_error), .unit = "1",
     .meaning = "estimate of the absolute error of eps_eff", .symbol = "δ{/:Italic ε}_{eff}",
     .quantity = "estimated error of {/:Italic ε}_{eff}", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, Er_Ef), .unit = "1",
     .meaning = "final energy relative to the centre of mass over final energy",
     .symbol = "{/:Italic E}_r/{/:Italic E}_f", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, Er_Ef_error), .unit = "1",
     .meaning = "estimate of the absolute error of Er_Ef", .symbol = "δ({/:Italic E}_r/{/:Italic E}_f)",
     .quantity = "estimated error of {/:Italic E}_r/{/:Italic E}_f", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, Er_E0), .unit = "1",
     .meaning = "final energy relative to the centre of mass over initial energy",
     .symbol = "{/:Italic E}_r/{/:Italic E}_0", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, v_cm), .unit = "1", .meaning = "final velocity of the centre of mass over v0",
     .symbol = "{/:Italic v}_{cm}/{/:Italic v}_0", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, v_cm_error), .unit = "1", .meaning = "estimate of the absolute error of v_cm",
     .symbol = "δ{/:Italic v}_{cm}/{/:Italic v}_0", .quantity = "estimated error of {/:Italic v}_{cm}/{/:Italic v}_0",
     .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, t_k), .unit = "s",
     .meaning = "time from the first to the last contact with the wall", .symbol = "{/:Italic t}_k",
     .quantity = "contact time of the column {/:Italic t}_k", .applies = {&conditions::flies}},
    {SIGMASWEEP_MEMBER(SimulationResult, x_max), .unit = "m", .meaning = "largest overlap of any contact",
     .symbol = "{/:Italic x}_{max}", .quantity = "largest overlap {/:Italic x}_{max}",
     .applies = {&conditions::overlaps}},
    {SIGMASWEEP_MEMBER(SimulationResult, predicted_growth), .unit = "1",
     .meaning = "fixed steps: predicted growth of the least stable mode in N tc (lattice: rows tc)",
     .applies = {&conditions::fixed_steps}},
    {SIGMASWEEP_MEMBER(SimulationResult, steps_used), .unit = "1",
     .meaning = "fixed steps: time steps per contact time that were chosen for the tolerance",
     .symbol = "{/:Italic t}_c/Δ{/:Italic t}", .applies = {&conditions::chosen_steps}},
    {SIGMASWEEP_MEMBER_NAMED("h_cm", SimulationResult, vibration.h_cm), .unit = "m",
     .meaning = "mean height of the centre of mass above the plate's middle", .symbol = "⟨{/:Italic h}_{cm}⟩",
     .quantity = "mean height of the centre of mass ⟨{/:Italic h}_{cm}⟩", .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("h_cm_error", SimulationResult, vibration.h_cm_error), .unit = "m",
     .meaning = "standard error of h_cm, by block averages; of periodic motion the error of the integration",
     .symbol = "δ{/:Italic h}_{cm}", .quantity = "standard error of ⟨{/:Italic h}_{cm}⟩",
     .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("h_cm_excess", SimulationResult, vibration.h_cm_excess), .unit = "m",
     .meaning = "h_cm less its value at rest with the plate in the middle", .symbol = "Δ{/:Italic h}_{cm}",
     .quantity = "rise of the centre of mass ⟨{/:Italic h}_{cm}⟩ − {/:Italic h}_{cm0}",
     .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("separation", SimulationResult, vibration.separation), .unit = "m",
     .meaning = "mean gap between neighbours, overlaps negative", .symbol = "⟨{/:Italic s}⟩",
     .quantity = "mean separation of neighbours ⟨{/:Italic s}⟩", .applies = {&conditions::vibrated_column}},
    {SIGMASWEEP_MEMBER_NAMED("separation_max", SimulationResult, vibration.separation_max), .unit = "m",
     .meaning = "largest gap between neighbours", .symbol = "{/:Italic s}_{max}",
     .quantity = "largest separation of neighbours {/:Italic s}_{max}", .applies = {&conditions::vibrated_column}},
    {SIGMASWEEP_MEMBER_NAMED("E_r", SimulationResult, vibration.E_r), .unit = "J/kg",
     .meaning = "mean kinetic energy relative to the centre of mass, over the mass", .symbol = "⟨{/:Italic E}_r⟩",
     .quantity = "energy of the relative motion ⟨{/:Italic E}_r⟩", .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("cm_period", SimulationResult, vibration.cm_period), .unit = "s",
     .meaning = "period of the centre of mass", .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("power_in", SimulationResult, vibration.power_in), .unit = "W/kg",
     .meaning = "mean power of the plate, over the mass", .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("power_lost", SimulationResult, vibration.power_lost), .unit = "W/kg",
     .meaning = "mean power dissipated in contacts, over the mass", .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER_NAMED("imbalance", SimulationResult, vibration.imbalance), .unit = "1",
     .meaning = "plate's work less dissipation and gain of energy, over max(plate's work, weight x plate's path)",
     .applies = {&conditions::vibrates}},
    {SIGMASWEEP_MEMBER(SimulationResult, contacts), .unit = "1",
     .meaning = "number of contacts that closed and opened again; hard spheres: of collisions; a lower bound where end "
                "is settled"},
    {SIGMASWEEP_MEMBER(SimulationResult, end), .unit = "1",
     .meaning = "why the computation ended; settled: some beads still approach, with next to no energy"},
    {SIGMASWEEP_MEMBER(SimulationResult, status), .unit = "1",
     .meaning = "whether the row holds a result, and if not, why"},
});

inline constexpr auto table_of_timings = std::to_array<FieldOf<Timing>>({
    {SIGMASWEEP_MEMBER(Timing, run_time), .unit = "s",
     .meaning = "CPU time of the tuple; of tuples computed together the share of their time"},
    {SIGMASWEEP_MEMBER(Timing, predicted_time), .unit = "s", .meaning = "CPU time predicted by the cost model"},
    {SIGMASWEEP_MEMBER(Timing, rank), .unit = "1", .meaning = "rank that computed the row"},
    {SIGMASWEEP_MEMBER(Timing, attempt), .unit = "1", .meaning = "number of the attempt; 1 for the first"},
});

}  // namespace sigmasweep
