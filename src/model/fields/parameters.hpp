#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "model/fields/conditions.hpp"
#include "model/fields/member.hpp"

/// The table of parameters, in the order in which they are stored and shown.
namespace sigmasweep {
namespace allowed {

using conditions::has_own_stiffness;

constexpr double max_beads = 1e6, max_periods = 1e7, max_alpha = 1e6;

inline bool positive(double value) { return std::isfinite(value) && value > 0.0; }
inline bool not_negative(double value) { return std::isfinite(value) && value >= 0.0; }
/// Whether a value is in an interval; false for NaN.
constexpr bool within(double value, double low, double high) { return value >= low && value <= high; }

inline constexpr AllowedValues speed{positive, "a finite speed > 0 m/s"};
inline constexpr AllowedValues time{positive, "a finite time > 0 s"};
inline constexpr AllowedValues length{positive, "a finite length > 0 m"};
inline constexpr AllowedValues gap{not_negative, "a finite length >= 0 m"};
inline constexpr AllowedValues sigma{not_negative, "finite and >= 0 (sigma = s0/(v0 tc))"};
inline constexpr AllowedValues coefficient{not_negative, "finite and >= 0"};
inline constexpr AllowedValues exponent{[](double value) { return within(value, 0.0, 4.0); }, "from 0 to 4"};
/// Restitution of a pair. A pair that never comes apart has epsilon = 0, which can only follow from K_over_m and D_n.
inline constexpr AllowedValues restitution{[](double value) { return value > 0.0 && value <= 1.0; }, "> 0 and <= 1",
                                           [](const Parameters& p) { return !(p.K_over_m > 0.0 && p.epsilon == 0.0); }};
/// Number of beads. For a lattice it follows from rows and columns.
inline constexpr AllowedValues beads{[](double value) { return within(value, 1.0, max_beads); },
                                     "a whole number from 1 to 1000000", conditions::column.holds};
inline constexpr AllowedValues beads_in_line{beads.contain, beads.must_be, conditions::lattice.holds};
inline constexpr AllowedValues tangential{not_negative, "finite and >= 0 1/s", conditions::lattice.holds};
/// Width of the diameters. The upper limit, 1.99 d, is checked by why_invalid().
inline constexpr AllowedValues width{not_negative, "from 0 to 1.99 d"};
inline constexpr AllowedValues seed{[](double value) { return value >= 0.0; }, ">= 0"};
/// Steps per tc. 0 stands for a step that is chosen for the tolerance.
inline constexpr AllowedValues steps{[](double value) { return value == 0.0 || within(value, 2.0, 1e6); },
                                     "from 2 to 1e6"};
inline constexpr AllowedValues tolerance{[](double value) { return within(value, 1e-15, 0.1); }, "from 1e-15 to 0.1"};
inline constexpr AllowedValues gravity{positive, "a finite acceleration > 0 m/s^2", conditions::vibrates.holds};
inline constexpr AllowedValues frequency{positive, "finite and > 0 Hz", conditions::vibrates.holds};
inline constexpr AllowedValues alpha{[](double value) { return value > 0.0 && value <= max_alpha; },
                                     "> 0 and <= 1000000 (alpha = A0 (2 pi frequency)^2/gravity)",
                                     conditions::vibrates.holds};
inline constexpr AllowedValues amplitude{positive, "a finite length > 0 m", conditions::vibrates.holds};
inline constexpr AllowedValues periods{[](double value) { return within(value, 1.0, max_periods); },
                                       "a whole number from 1 to 10000000", conditions::vibrates.holds};
/// Initial periods. The upper limit, periods - 1, is checked by why_invalid().
inline constexpr AllowedValues transient{[](double value) { return within(value, 0.0, max_periods - 1.0); },
                                         "a whole number from 0 to periods - 1", conditions::vibrates.holds};

}  // namespace allowed

inline constexpr auto table_of_parameters = std::to_array<ParameterField>({
    {SIGMASWEEP_MEMBER(Parameters, v0), .unit = "m/s",
     .meaning = "approach speed; vibrated: speed at which a nonlinear law has tc and epsilon",
     .symbol = "{/:Italic v}_0", .applies = {&conditions::speed}, .allowed = allowed::speed,
     .always_column = &conditions::flies},
    {SIGMASWEEP_MEMBER(Parameters, tc), .unit = "s",
     .meaning = "contact time of a pair of beads, Eq. (6); nonlinear: at v0, Eq. (A2)", .symbol = "{/:Italic t}_c",
     .applies = {&conditions::contact_time}, .allowed = allowed::time,
     .always_column = &conditions::tabulated_contact_time},
    {SIGMASWEEP_MEMBER(Parameters, s0), .unit = "m",
     .meaning = "initial gap between neighbours and to the wall or plate", .symbol = "{/:Italic s}_0",
     .allowed = allowed::gap, .always_column = &conditions::flies},
    {SIGMASWEEP_MEMBER(Parameters, sigma), .unit = "1",
     .meaning = "s0/(v0 tc), time between contacts over contact time", .symbol = "{/:Italic σ}",
     .quantity = "{/:Italic σ} = {/:Italic s}_0 / ({/:Italic v}_0 {/:Italic t}_c)", .applies = {&conditions::flies},
     .allowed = allowed::sigma, .always_column = &conditions::flies},
    {SIGMASWEEP_MEMBER(Parameters, N), .unit = "1", .meaning = "number of beads; lattice: rows times columns",
     .symbol = "{/:Italic N}", .applies = {&conditions::column}, .allowed = allowed::beads,
     .always_column = &conditions::always},
    {SIGMASWEEP_MEMBER(Parameters, epsilon), .unit = "1",
     .meaning = "restitution of a pair of beads, Eq. (7); nonlinear: at v0, which hard spheres have in all collisions",
     .symbol = "{/:Italic ε}", .applies = {&conditions::by_contact}, .allowed = allowed::restitution,
     .always_column = &conditions::always},
    {SIGMASWEEP_MEMBER(Parameters, method), .unit = "1", .meaning = "md: soft spheres; ed: hard spheres, event-driven",
     .always_column = &conditions::always},
    {SIGMASWEEP_MEMBER(Parameters, geometry), .unit = "1",
     .meaning = "column, lattice: collision with a wall; vibrated-: on a plate"},
    {SIGMASWEEP_MEMBER(Parameters, rows), .unit = "1", .meaning = "lattice: number of rows of beads",
     .applies = {&conditions::lattice}, .allowed = allowed::beads_in_line, .always_column = &conditions::lattice},
    {SIGMASWEEP_MEMBER(Parameters, columns), .unit = "1", .meaning = "lattice: number of beads in a row",
     .applies = {&conditions::lattice}, .allowed = allowed::beads_in_line, .always_column = &conditions::lattice},
    {SIGMASWEEP_MEMBER(Parameters, D_t), .unit = "1/s",
     .meaning = "lattice: tangential dashpot over twice the reduced mass, Eq. (4)", .symbol = "{/:Italic D}_t",
     .applies = {&conditions::lattice}, .allowed = allowed::tangential},
    {SIGMASWEEP_MEMBER(Parameters, side_walls), .unit = "1",
     .meaning = "lattice: periodic, no side walls; fixed, walls like the bottom", .applies = {&conditions::lattice}},
    {SIGMASWEEP_MEMBER(Parameters, wall), .unit = "1",
     .meaning = "paper: same spring and dashpot as a pair; matched: same tc and epsilon"},
    {SIGMASWEEP_MEMBER(Parameters, law), .unit = "1", .meaning = "contact force F = K x^(1+beta) + D x^gamma x'",
     .applies = {&conditions::law}},
    {SIGMASWEEP_MEMBER(Parameters, beta), .unit = "1", .meaning = "power law: exponent of the spring",
     .symbol = "{/:Italic β}", .applies = {&conditions::free_exponents}, .allowed = allowed::exponent},
    {SIGMASWEEP_MEMBER(Parameters, gamma), .unit = "1", .meaning = "power law: exponent of the dashpot",
     .symbol = "{/:Italic γ}", .applies = {&conditions::free_exponents}, .allowed = allowed::exponent},
    {SIGMASWEEP_MEMBER(Parameters, K_over_m), .unit = "1/(s^2 m^beta)",
     .meaning = "spring of a pair over its reduced mass", .applies = {&conditions::by_spring},
     .allowed = allowed::coefficient},
    {SIGMASWEEP_MEMBER(Parameters, D_n), .unit = "1/(s m^gamma)",
     .meaning = "dashpot of a pair over twice its reduced mass", .symbol = "{/:Italic D}_n",
     .applies = {&conditions::by_spring}, .allowed = allowed::coefficient},
    {SIGMASWEEP_MEMBER(Parameters, material), .unit = "1",
     .meaning = "diameter, stiffness and damping of the beads of Sec. III", .applies = {&conditions::by_material}},
    {SIGMASWEEP_MEMBER(Parameters, integrator), .unit = "1", .meaning = "md: exact, or a scheme of fixed time step",
     .applies = {&conditions::soft}},
    {SIGMASWEEP_MEMBER(Parameters, d), .unit = "m", .meaning = "bead diameter", .symbol = "{/:Italic d}",
     .applies = {&conditions::own_diameter}, .allowed = allowed::length},
    {SIGMASWEEP_MEMBER(Parameters, width), .unit = "m", .meaning = "diameters are uniform in d +- width/2",
     .allowed = allowed::width},
    {SIGMASWEEP_MEMBER(Parameters, random_separation), .unit = "1",
     .meaning = "whether each bead starts with a random shift of up to +- s0/2", .applies = {&conditions::gap}},
    {SIGMASWEEP_MEMBER(Parameters, seed), .unit = "1", .meaning = "seed of random diameters and separations",
     .applies = {&conditions::random}, .allowed = allowed::seed},
    {SIGMASWEEP_MEMBER(Parameters, ed_rule), .unit = "1",
     .meaning = "ed: lrv, all collisions dissipate; tc, none within tc after another", .applies = {&conditions::hard}},
    {SIGMASWEEP_MEMBER(Parameters, steps_per_tc), .unit = "1",
     .meaning = "fixed steps: time steps per contact time (or give a tolerance)",
     .symbol = "{/:Italic t}_c/Δ{/:Italic t}", .applies = {&conditions::given_steps}, .allowed = allowed::steps},
    {SIGMASWEEP_MEMBER(Parameters, tolerance), .unit = "1",
     .meaning = "wanted absolute error of eps_eff, of exact or of a time step chosen for it",
     .applies = {&conditions::flies, &conditions::tolerance}, .allowed = allowed::tolerance},
    {SIGMASWEEP_MEMBER(Parameters, gravity), .unit = "m/s^2", .meaning = "vibrated: acceleration of gravity",
     .symbol = "{/:Italic g}", .applies = {&conditions::vibrates}, .allowed = allowed::gravity},
    {SIGMASWEEP_MEMBER(Parameters, frequency), .unit = "Hz",
     .meaning = "vibrated: f of the plate A0 sin(2 pi f t), Eq. (1)", .symbol = "{/:Italic f}",
     .applies = {&conditions::vibrates}, .allowed = allowed::frequency, .always_column = &conditions::vibrates},
    {SIGMASWEEP_MEMBER(Parameters, alpha), .unit = "1",
     .meaning = "vibrated: A0 (2 pi f)^2/g, plate's acceleration over gravity", .symbol = "{/:Italic α}",
     .quantity = "{/:Italic α} = {/:Italic A}_0 {/:Italic ω}^2/{/:Italic g}", .applies = {&conditions::vibrates},
     .allowed = allowed::alpha, .always_column = &conditions::vibrates},
    {SIGMASWEEP_MEMBER(Parameters, A0), .unit = "m", .meaning = "vibrated: amplitude of the plate",
     .symbol = "{/:Italic A}_0", .applies = {&conditions::vibrates}, .allowed = allowed::amplitude,
     .always_column = &conditions::vibrates},
    {SIGMASWEEP_MEMBER(Parameters, periods), .unit = "1", .meaning = "vibrated: number of periods that are computed",
     .applies = {&conditions::vibrates}, .allowed = allowed::periods, .always_column = &conditions::vibrates},
    {SIGMASWEEP_MEMBER(Parameters, transient), .unit = "1",
     .meaning = "vibrated: initial periods that are excluded from the averages", .applies = {&conditions::vibrates},
     .allowed = allowed::transient},
});

}  // namespace sigmasweep
