#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "base/exit_codes.hpp"
#include "base/text/numbers.hpp"
#include "cli/command.hpp"
#include "cli/typed_tuple.hpp"
#include "sigmasweep/base/errors.hpp"
#include "studies/advice/advice.hpp"
#include "studies/advice/decks.hpp"

namespace sigmasweep {
namespace {

/// The parameters that are options.
constexpr auto parameters =
    std::to_array<std::string_view>({"v0", "tc", "s0", "sigma", "N", "epsilon", "d", "wall", "K_over_m", "D_n"});

struct AdviseOptions {
  TypedParameters given;
  std::string density, mass, stiffness, steps = "50";
  bool json = false;
};

std::optional<double> positive(const std::string& typed, std::string_view option) {
  if (typed.empty()) return std::nullopt;
  const auto value = parse_number(typed);
  if (!value || !(*value > 0.0 && std::isfinite(*value)))
    throw UsageError(fmt::format("--{} {}: a number > 0 is needed", option, typed));
  return value;
}

double mass_of(const AdviseOptions& options, double d) {
  const auto mass = positive(options.mass, "mass"), density = positive(options.density, "density");
  if (mass && density) throw UsageError("give --mass or --density, not both");
  if (mass) return *mass;
  return density.value_or(2500.0) * std::numbers::pi / 6.0 * d * d * d;
}

Parameters tuple_of(const AdviseOptions& options) {
  TypedParameters given = options.given;
  const auto number = [&](std::string_view name, double usual) {
    const auto found = given.find(name);
    return found == given.end() ? usual : parse_number(found->second).value_or(usual);
  };
  if (const auto stiffness = positive(options.stiffness, "stiffness")) {
    if (given.contains("tc")) throw UsageError("give --tc or --stiffness, not both");
    if (!given.contains("epsilon")) throw UsageError("--stiffness needs --epsilon");
    given["tc"] =
        fmt::format("{}", tc_of(mass_of(options, number("d", Parameters{}.d)), *stiffness, number("epsilon", 1)));
  }
  return sweep_of(given, "advise").at(0);
}

/// Percent of the energy that is lost.
double lost(const SimulationResult& result) { return 100.0 * (1.0 - result.eps_eff * result.eps_eff); }

std::string verdict(const Advice& a) {
  if (a.hard.status == Status::collapsed) return "hard beads collapse: they lose all energy, soft ones never do";
  if (!a.hard_from) return "eps_eff is not that of hard beads for any stiffness";
  if (a.is_near_hard()) return "stiff enough: eps_eff is within 5 % of that of hard beads";
  return fmt::format("too soft: the column loses {:.3g} % of its energy, hard beads lose {:.3g} %", lost(a.soft),
                     lost(a.hard));
}

std::string needed(const Advice& a) {
  if (!a.hard_from) return {};
  if (*a.hard_from == 0.0) return "at any sigma";
  const std::string from = fmt::format("from sigma = {:.6g} on", *a.hard_from);
  const auto tc = a.hard_tc();
  if (!tc) return from + "; beads in touch, sigma = 0, are soft for any stiffness";
  return fmt::format("{}: here tc <= {:.4g} s, K >= {:.4g} N/m", from, *tc, stiffness_of(a.mass, *tc, a.tuple.epsilon));
}

void print_text(const Advice& a, int steps) {
  const Parameters& p = a.tuple;
  fmt::print("a bead         d = {:.6g} m, m = {:.6g} kg\n", p.d, a.mass);
  fmt::print("a contact      tc = {:.6g} s, epsilon = {:.6g}: K = {:.6g} N/m, dashpot {:.6g} N s/m\n", p.tc, p.epsilon,
             a.stiffness, a.dashpot);
  fmt::print("overlaps       up to {:.3g} m, {:.3g} % of d\n", a.soft.x_max, 100.0 * a.soft.x_max / p.d);
  fmt::print("sigma          {:.6g} = s0/(v0 tc): the time between contacts over that of a contact\n", p.sigma);
  fmt::print("eps_eff        {:.8g} +- {:.1g} of soft beads, {:.8g} +- {:.1g} of hard ones\n", a.soft.eps_eff,
             a.soft.eps_eff_error, a.hard.eps_eff, a.hard.eps_eff_error);
  fmt::print("verdict        {}\n", verdict(a));
  if (const std::string from = needed(a); !from.empty()) fmt::print("as hard beads  {}\n", from);
  fmt::print("\nvelocity Verlet   eps_eff      error\n");
  for (const Advice::Step& step : a.steps)
    fmt::print("  tc/{:<12} {:<12.8g} {:.1e}{}\n", step.steps_per_tc, step.eps_eff, step.error,
               step.stable ? "" : "  not stable");
  for (const Deck& deck : decks())
    fmt::print("\n{}{}{}\n{}", deck.code, deck.remark.empty() ? "" : ": ", deck.remark, deck.lines(a, p.tc / steps));
}

nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

void print_json(const Advice& a, int steps) {
  nlohmann::ordered_json document = {{"d", a.tuple.d},
                                     {"mass", a.mass},
                                     {"tc", a.tuple.tc},
                                     {"epsilon", a.tuple.epsilon},
                                     {"stiffness", a.stiffness},
                                     {"dashpot", a.dashpot},
                                     {"sigma", a.tuple.sigma},
                                     {"x_max", number(a.soft.x_max)},
                                     {"eps_eff", number(a.soft.eps_eff)},
                                     {"eps_eff_error", number(a.soft.eps_eff_error)},
                                     {"eps_eff_hard", number(a.hard.eps_eff)},
                                     {"eps_eff_hard_error", number(a.hard.eps_eff_error)},
                                     {"as_hard", a.is_near_hard()}};
  const auto tc = a.hard_tc();
  document["hard_from_sigma"] = a.hard_from ? number(*a.hard_from) : nullptr;
  document["hard_tc"] = tc ? number(*tc) : nullptr;
  document["hard_stiffness"] = tc ? number(stiffness_of(a.mass, *tc, a.tuple.epsilon)) : nullptr;
  document["steps"] = nlohmann::ordered_json::array();
  for (const Advice::Step& step : a.steps)
    document["steps"].push_back({{"steps_per_tc", step.steps_per_tc},
                                 {"eps_eff", number(step.eps_eff)},
                                 {"error", number(step.error)},
                                 {"stable", step.stable}});
  for (const Deck& deck : decks()) document["lines"][std::string(deck.code)] = deck.lines(a, a.tuple.tc / steps);
  fmt::print("{}\n", document.dump(2));
}

int give_advice(const AdviseOptions& options) {
  const Parameters tuple = tuple_of(options);
  const auto steps = parse_whole_number(options.steps);
  if (!steps || *steps < 2 || *steps > 1'000'000) throw UsageError("--steps-per-tc: a whole number from 2 to 1e6");
  if (!(tuple.epsilon > 0.0)) throw UsageError("pairs that are damped so strongly do not come apart: epsilon is 0");
  const Advice advice = advise(tuple, mass_of(options, tuple.d));
  options.json ? print_json(advice, static_cast<int>(*steps)) : print_text(advice, static_cast<int>(*steps));
  return is_success(advice.soft.status) ? exit_code::success : exit_code::some_rows_failed;
}

void declare(OptionSet& set, AdviseOptions& options) {
  for (const std::string_view name : parameters) {
    const Field& field = *find_field(name);
    std::string dashed(name);
    std::ranges::replace(dashed, '_', '-');
    const auto names = enumerators(field.type);
    Option option{"--" + dashed,
                  std::string(field.meaning) + (field.unit == "1" ? "" : fmt::format(" ({})", field.unit)),
                  names.empty() ? "NUMBER" : "NAME",
                  {names.begin(), names.end()}};
    if (names.empty())
      option.complaint = [](const std::string& typed) {
        return parse_number(typed) ? std::string() : fmt::format("'{}' is not a number{}", typed, number_hint(typed));
      };
    set.add(option, [&options, name](const std::string& typed) {
      options.given[name] = typed;
      return true;
    });
  }
  set.add({"--density", "Density of the beads, kg/m^3; default 2500", "NUMBER"}, options.density);
  set.add({"--mass", "Mass of a bead, kg, instead of the density", "NUMBER"}, options.mass);
  set.add({"--stiffness", "Spring of a pair, N/m, instead of tc", "NUMBER"}, options.stiffness);
  set.add({"--steps-per-tc", "Time step of the lines for other codes, tc/NUMBER; default 50", "NUMBER"}, options.steps);
  set.add_flag("--json", "One JSON document", options.json);
}

}  // namespace

Command advise_command() {
  return make_command(
      "advise", "Are my DEM parameters too soft? And what do I type in other codes?",
      "\nA column of N soft beads (linear springs) flies into a wall. It is compared with hard beads: from which "
      "sigma, so\n"
      "which contact time and stiffness, on is the effective restitution within 5 % of theirs? Then the error of time\n"
      "steps, and lines with the same contacts for LAMMPS, LIGGGHTS, Yade and MercuryDPM, in SI units.\n\n"
      "  sigmasweep advise --d 1e-3 --density 2500 --epsilon 0.9 --tc 2e-5 --v0 1 --s0 1e-6 --N 10\n"
      "  sigmasweep advise --d 1e-3 --epsilon 0.9 --stiffness 1e4 --v0 0.1 --s0 1e-5 --N 5",
      declare, give_advice);
}

}  // namespace sigmasweep
