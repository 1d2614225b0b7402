#include "sigmasweep/model/fields.hpp"

#include <array>
#include <cassert>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "sigmasweep/model/names.hpp"

namespace sigmasweep {
namespace {

static_assert(std::is_standard_layout_v<Row> && std::is_trivially_copyable_v<Row>);

/// The field type that a member of a row has.
template <class T>
constexpr FieldType type_of() {
  if constexpr (std::is_same_v<T, double>)
    return FieldType::real;
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return FieldType::integer;
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return FieldType::unsigned_integer;
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return FieldType::integer32;
  else if constexpr (std::is_same_v<T, Method>)
    return FieldType::method;
  else if constexpr (std::is_same_v<T, Geometry>)
    return FieldType::geometry;
  else if constexpr (std::is_same_v<T, Wall>)
    return FieldType::wall;
  else if constexpr (std::is_same_v<T, Integrator>)
    return FieldType::integrator;
  else if constexpr (std::is_same_v<T, Law>)
    return FieldType::law;
  else if constexpr (std::is_same_v<T, Material>)
    return FieldType::material;
  else if constexpr (std::is_same_v<T, EdRule>)
    return FieldType::ed_rule;
  else if constexpr (std::is_same_v<T, Flag>)
    return FieldType::flag;
  else if constexpr (std::is_same_v<T, SideWalls>)
    return FieldType::side_walls;
  else if constexpr (std::is_same_v<T, End>)
    return FieldType::end;
  else if constexpr (std::is_same_v<T, Status>)
    return FieldType::status;
}

#define SIGMASWEEP_FIELD(part, member, unit, meaning) \
  Field { #member, unit, meaning, type_of < decltype(Row::part.member)>(), offsetof(Row, part.member) }
#define SIGMASWEEP_VIBRATION(member, unit, meaning) \
  Field { #member, unit, meaning, FieldType::real, offsetof(Row, result.vibration.member) }

constexpr std::array parameters{
    SIGMASWEEP_FIELD(parameters, v0, "m/s", "approach speed; vibrated: at which tc and epsilon hold if nonlinear"),
    SIGMASWEEP_FIELD(parameters, tc, "s", "contact time of a pair of beads, Eq. (6); nonlinear: at v0, Eq. (A2)"),
    SIGMASWEEP_FIELD(parameters, s0, "m", "initial gap between neighbours and to the wall or plate"),
    SIGMASWEEP_FIELD(parameters, sigma, "1", "s0/(v0 tc), time between contacts over contact time"),
    SIGMASWEEP_FIELD(parameters, N, "1", "number of beads; of a lattice rows times columns"),
    SIGMASWEEP_FIELD(parameters, epsilon, "1", "restitution of a pair of beads, Eq. (7); nonlinear: at v0"),
    SIGMASWEEP_FIELD(parameters, method, "1", "md: soft spheres; ed: hard spheres, event-driven"),
    SIGMASWEEP_FIELD(parameters, geometry, "1", "column, lattice: flies into a wall; vibrated-: on a plate"),
    SIGMASWEEP_FIELD(parameters, rows, "1", "lattice: its height, in rows of beads"),
    SIGMASWEEP_FIELD(parameters, columns, "1", "lattice: beads in a row"),
    SIGMASWEEP_FIELD(parameters, D_t, "1/s", "lattice: tangential dashpot over twice the reduced mass, Eq. (4)"),
    SIGMASWEEP_FIELD(parameters, side_walls, "1", "lattice: periodic, none; fixed, on both sides, like the bottom"),
    SIGMASWEEP_FIELD(parameters, wall, "1", "paper: same spring and dashpot as a pair; matched: same tc and epsilon"),
    SIGMASWEEP_FIELD(parameters, law, "1", "of the contact force, F = K x^(1+beta) + D x^gamma x'"),
    SIGMASWEEP_FIELD(parameters, beta, "1", "power law: exponent of the spring"),
    SIGMASWEEP_FIELD(parameters, gamma, "1", "power law: exponent of the dashpot"),
    SIGMASWEEP_FIELD(parameters, K_over_m, "1/(s^2 m^beta)", "spring of a pair over its reduced mass"),
    SIGMASWEEP_FIELD(parameters, D_n, "1/(s m^gamma)", "dashpot of a pair over twice its reduced mass"),
    SIGMASWEEP_FIELD(parameters, material, "1", "beads of Sec. III: their diameter, stiffness and damping"),
    SIGMASWEEP_FIELD(parameters, integrator, "1", "how soft spheres are moved"),
    SIGMASWEEP_FIELD(parameters, d, "m", "bead diameter"),
    SIGMASWEEP_FIELD(parameters, width, "m", "diameters are uniform in d +- width/2"),
    SIGMASWEEP_FIELD(parameters, random_separation, "1", "whether each bead is shifted by up to +- s0/2 at the start"),
    SIGMASWEEP_FIELD(parameters, seed, "1", "of random diameters and separations"),
    SIGMASWEEP_FIELD(parameters, ed_rule, "1", "ed: lrv, each collision loses; tc, none soon after another one"),
    SIGMASWEEP_FIELD(parameters, steps_per_tc, "1",
                     "gear5, verlet, rk4: time steps per contact time (or give a tolerance)"),
    SIGMASWEEP_FIELD(parameters, tolerance, "1",
                     "wanted absolute error of eps_eff: of exact, or of a time step chosen for it"),
    SIGMASWEEP_FIELD(parameters, gravity, "m/s^2", "vibrated: acceleration of gravity"),
    SIGMASWEEP_FIELD(parameters, frequency, "Hz", "vibrated: f of the plate A0 sin(2 pi f t), Eq. (1)"),
    SIGMASWEEP_FIELD(parameters, alpha, "1", "vibrated: A0 (2 pi f)^2/g, plate's acceleration over gravity"),
    SIGMASWEEP_FIELD(parameters, A0, "m", "vibrated: amplitude of the plate"),
    SIGMASWEEP_FIELD(parameters, periods, "1", "vibrated: of the plate, how long the beads are followed"),
    SIGMASWEEP_FIELD(parameters, transient, "1", "vibrated: of these, the first ones, which no average takes in"),
};

constexpr std::array results{
    SIGMASWEEP_FIELD(result, eps_eff, "1", "effective restitution sqrt(E_f/E_0)"),
    SIGMASWEEP_FIELD(result, eps_eff_error, "1", "estimate of the absolute error of eps_eff"),
    SIGMASWEEP_FIELD(result, Er_Ef, "1", "final energy relative to the centre of mass over final energy"),
    SIGMASWEEP_FIELD(result, Er_E0, "1", "final energy relative to the centre of mass over initial energy"),
    SIGMASWEEP_FIELD(result, v_cm, "1", "final velocity of the centre of mass over v0"),
    SIGMASWEEP_FIELD(result, t_k, "s", "time from the first to the last contact with the wall"),
    SIGMASWEEP_FIELD(result, x_max, "m", "largest overlap of any contact"),
    SIGMASWEEP_FIELD(result, predicted_growth, "1",
                     "fixed steps: of the least stable mode in N tc (lattice: rows tc), by theory"),
    SIGMASWEEP_VIBRATION(h_cm, "m", "mean height of the centre of mass above the plate's middle"),
    SIGMASWEEP_VIBRATION(h_cm_error, "m", "standard error of h_cm, by block averages"),
    SIGMASWEEP_VIBRATION(h_cm_excess, "m", "h_cm less its value at rest with the plate in the middle"),
    SIGMASWEEP_VIBRATION(separation, "m", "mean gap between neighbours, overlaps negative"),
    SIGMASWEEP_VIBRATION(separation_max, "m", "largest gap between neighbours"),
    SIGMASWEEP_VIBRATION(E_r, "J/kg", "mean kinetic energy relative to the centre of mass, over the mass"),
    SIGMASWEEP_VIBRATION(cm_period, "s", "after which the centre of mass repeats its motion"),
    SIGMASWEEP_VIBRATION(power_in, "W/kg", "mean power of the plate, over the mass"),
    SIGMASWEEP_VIBRATION(power_lost, "W/kg", "mean power lost in contacts, over the mass"),
    SIGMASWEEP_VIBRATION(imbalance, "1",
                         "work in less work lost and gain of energy, over max(work in, weight x plate's path)"),
    SIGMASWEEP_FIELD(result, contacts, "1", "contacts closed and opened again; for hard spheres collisions"),
    SIGMASWEEP_FIELD(result, end, "1", "why the collision was considered over; periods: all that were asked for"),
    SIGMASWEEP_FIELD(result, status, "1", "whether the row holds what was asked for"),
};

constexpr std::array timings{
    SIGMASWEEP_FIELD(timing, run_time, "s", "CPU time spent on the tuple"),
    SIGMASWEEP_FIELD(timing, predicted_time, "s", "CPU time that the cost model predicted"),
    SIGMASWEEP_FIELD(timing, rank, "1", "rank that computed the row"),
    SIGMASWEEP_FIELD(timing, attempt, "1", "1 for the first try"),
};

#undef SIGMASWEEP_FIELD
#undef SIGMASWEEP_VIBRATION

template <class T>
T load(const Field& field, const Row& row) {
  T value;
  std::memcpy(&value, reinterpret_cast<const char*>(&row) + field.offset, sizeof value);
  return value;
}

template <class T>
void store(const Field& field, Row& row, double number) {
  const T value = static_cast<T>(number);
  std::memcpy(reinterpret_cast<char*>(&row) + field.offset, &value, sizeof value);
}

}  // namespace

std::span<const Field> parameter_fields() { return parameters; }
std::span<const Field> result_fields() { return results; }
std::span<const Field> timing_fields() { return timings; }

std::vector<Field> all_fields() {
  std::vector<Field> all;
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    all.insert(all.end(), fields.begin(), fields.end());
  return all;
}

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const Field& field : all_fields()) names.push_back(field.name);
  return names;
}

const Field* find_field(std::string_view name) {
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : fields)
      if (field.name == name) return &field;
  return nullptr;
}

std::span<const std::string_view> enumerators(FieldType type) {
  switch (type) {
    case FieldType::method: return names_of<Method>();
    case FieldType::geometry: return names_of<Geometry>();
    case FieldType::wall: return names_of<Wall>();
    case FieldType::integrator: return names_of<Integrator>();
    case FieldType::law: return names_of<Law>();
    case FieldType::material: return names_of<Material>();
    case FieldType::ed_rule: return names_of<EdRule>();
    case FieldType::flag: return names_of<Flag>();
    case FieldType::side_walls: return names_of<SideWalls>();
    case FieldType::end: return names_of<End>();
    case FieldType::status: return names_of<Status>();
    default: return {};
  }
}

double number(const Field& field, const Row& row) {
  switch (field.type) {
    case FieldType::real: return load<double>(field, row);
    case FieldType::integer: return static_cast<double>(load<std::int64_t>(field, row));
    case FieldType::unsigned_integer: return static_cast<double>(load<std::uint64_t>(field, row));
    case FieldType::integer32: return load<std::int32_t>(field, row);
    default: return load<std::uint8_t>(field, row);  // the enumerations
  }
}

void set_number(const Field& field, Row& row, double value) {
  switch (field.type) {
    case FieldType::real: return store<double>(field, row, value);
    case FieldType::integer: return store<std::int64_t>(field, row, value);
    case FieldType::unsigned_integer: return store<std::uint64_t>(field, row, value);
    case FieldType::integer32: return store<std::int32_t>(field, row, value);
    default:
      assert(value < static_cast<double>(enumerators(field.type).size()));
      return store<std::uint8_t>(field, row, value);
  }
}

std::string text(const Field& field, const Row& row) {
  switch (field.type) {
    case FieldType::real: return fmt::format("{}", load<double>(field, row));
    case FieldType::integer: return fmt::format("{}", load<std::int64_t>(field, row));
    case FieldType::unsigned_integer: return fmt::format("{}", load<std::uint64_t>(field, row));
    case FieldType::integer32: return fmt::format("{}", load<std::int32_t>(field, row));
    default: break;
  }
  const auto names = enumerators(field.type);
  const auto value = load<std::uint8_t>(field, row);
  return value < names.size() ? std::string(names[value]) : fmt::format("{}", value);
}

}  // namespace sigmasweep
