#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/sweep/content_key.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <new>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sigmasweep/sweep/sweep.hpp"
#include "support/columns.hpp"

using namespace sigmasweep;

namespace {

std::vector<std::string> names(std::span<const Field> fields) {
  std::vector<std::string> all;
  for (const Field& field : fields) all.emplace_back(field.name);
  return all;
}

std::string shown(std::string_view name, const Row& row) { return text(*find_field(name), row); }

}  // namespace

TEST(Fields, ListsAreComplete) {
  EXPECT_EQ(names(parameter_fields()), golden::names_of(golden::Part::parameters));
  EXPECT_EQ(names(result_fields()), golden::names_of(golden::Part::results));
  EXPECT_EQ(names(timing_fields()), golden::names_of(golden::Part::timings));
  EXPECT_EQ(find_field("no such field"), nullptr);
}

TEST(Fields, EachSitsAtItsMember) {
  Row row;
  row.parameters.v0 = 1.5;
  row.parameters.N = 123456789012;
  row.parameters.integrator = Integrator::verlet;
  row.result.x_max = 2.5e-6;
  row.result.contacts = 4096;
  row.result.status = Status::event_limit;
  row.timing.rank = -7;
  EXPECT_EQ(number(*find_field("v0"), row), 1.5);
  EXPECT_EQ(number(*find_field("N"), row), 123456789012.0);
  EXPECT_EQ(number(*find_field("integrator"), row), 2.0);
  EXPECT_EQ(number(*find_field("x_max"), row), 2.5e-6);
  EXPECT_EQ(number(*find_field("contacts"), row), 4096.0);
  EXPECT_EQ(number(*find_field("rank"), row), -7.0);
  EXPECT_EQ(shown("integrator", row), "verlet");
  EXPECT_EQ(shown("status", row), "event_limit");
  EXPECT_EQ(shown("end", row), "none");
  row.parameters.law = Law::hertz_kuwabara_kono;
  row.parameters.random_separation = Flag::yes;
  row.parameters.ed_rule = EdRule::tc;
  row.parameters.material = Material::aluminium;
  EXPECT_EQ(shown("law", row), "hertz-kuwabara-kono");
  EXPECT_EQ(shown("random_separation", row), "true");
  EXPECT_EQ(shown("ed_rule", row), "tc");
  EXPECT_EQ(shown("material", row), "aluminium");
  row.parameters.geometry = Geometry::vibrated_column;
  row.parameters.transient = 7;
  row.result.vibration.imbalance = 3e-9;
  EXPECT_EQ(shown("geometry", row), "vibrated-column");
  row.parameters.geometry = Geometry::vibrated_lattice;
  row.parameters.side_walls = SideWalls::fixed;
  row.parameters.columns = 17;
  row.result.end = End::quiet;
  EXPECT_EQ(shown("geometry", row), "vibrated-lattice");
  EXPECT_EQ(shown("side_walls", row), "fixed");
  EXPECT_EQ(number(*find_field("columns"), row), 17.0);
  EXPECT_EQ(shown("end", row), "quiet");
  EXPECT_EQ(number(*find_field("transient"), row), 7.0);
  EXPECT_EQ(number(*find_field("imbalance"), row), 3e-9);
}

TEST(Fields, ParametersAreReadAndSetAlone) {
  const auto of_rows = parameter_fields();
  const auto alone = fields_of_parameters();
  ASSERT_EQ(alone.size(), of_rows.size());
  Row row;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].name, of_rows[i].name);
    EXPECT_EQ(find_parameter(alone[i].name), &alone[i]);
    set_number(alone[i], row.parameters, 1.0);
    EXPECT_EQ(number(of_rows[i], row), 1.0) << alone[i].name;
    EXPECT_EQ(number(alone[i], row.parameters), 1.0) << alone[i].name;
    EXPECT_EQ(text(alone[i], row.parameters), text(of_rows[i], row));
  }
  EXPECT_EQ(find_parameter("eps_eff"), nullptr);
}

TEST(Fields, RefusalsNameTheFieldItsValueAndWhatIsAllowed) {
  EXPECT_EQ(why_refused(*find_parameter("v0"), -1.0, "-1"),
            "v0 = -1 is not allowed: it must be a finite speed > 0 m/s.");
  EXPECT_EQ(why_refused(*find_parameter("N"), 0.0, "0"),
            "N = 0 is not allowed: it must be a whole number from 1 to 1000000.");
  EXPECT_EQ(why_refused(*find_parameter("steps_per_tc"), 0.0, "0"), "");  // chosen by the tolerance
  EXPECT_EQ(why_refused(*find_parameter("method"), 1.0, "1"), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ParameterField& field : fields_of_parameters()) {
    if (!enumerators(field.type).empty()) continue;
    EXPECT_NE(why_refused(field, nan, "nan"), "") << field.name;
  }
}

TEST(Fields, NoTwoOverlap) {
  std::set<std::size_t> offsets;
  std::size_t count = 0;
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : fields) {
      EXPECT_FALSE(field.unit.empty()) << field.name;
      EXPECT_FALSE(field.meaning.empty()) << field.name;
      offsets.insert(field.offset);
      ++count;
    }
  EXPECT_EQ(offsets.size(), count);
}

TEST(Fields, TextIsTheShortestThatReadsBack) {
  Row row;
  for (const double value : {0.1, 1e-9, 1.0 / 3.0, 0.341547467017, 5e-324, 1.7976931348623157e308}) {
    row.parameters.s0 = value;
    EXPECT_EQ(std::strtod(shown("s0", row).c_str(), nullptr), value);
  }
  row.parameters.s0 = 0.1;
  EXPECT_EQ(shown("s0", row), "0.1");
  row.parameters.s0 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(shown("s0", row), "nan");
}

TEST(Fields, SetNumberIsTheReverseOfNumber) {
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : fields) {
      Row row;
      set_number(field, row, 1.0);
      EXPECT_EQ(number(field, row), 1.0) << field.name;
    }
}

TEST(ContentKey, ChangesWithEveryParameter) {
  std::set<std::uint64_t> keys{content_key(Parameters{})};
  const std::vector<std::function<void(Parameters&)>> changes{
      [](Parameters& p) { p.v0 = std::nextafter(p.v0, 2.0); },
      [](Parameters& p) { p.tc = std::nextafter(p.tc, 2.0); },
      [](Parameters& p) { p.s0 = 5e-324; },
      [](Parameters& p) { p.sigma = 5e-324; },
      [](Parameters& p) { p.epsilon = std::nextafter(p.epsilon, 2.0); },
      [](Parameters& p) { p.d = std::nextafter(p.d, 2.0); },
      [](Parameters& p) { p.steps_per_tc = std::nextafter(p.steps_per_tc, 2.0); },
      [](Parameters& p) { p.tolerance = std::nextafter(p.tolerance, 2.0); },
      [](Parameters& p) { p.N += 1; },
      [](Parameters& p) { p.method = Method::ed; },
      [](Parameters& p) { p.wall = Wall::matched; },
      [](Parameters& p) { p.integrator = Integrator::gear5; },
      [](Parameters& p) { p.integrator = Integrator::rk4; },
      [](Parameters& p) { p.law = Law::hertz; },
      [](Parameters& p) { p.law = Law::power; },
      [](Parameters& p) { p.beta = 5e-324; },
      [](Parameters& p) { p.gamma = 5e-324; },
      [](Parameters& p) { p.K_over_m = 5e-324; },
      [](Parameters& p) { p.D_n = 5e-324; },
      [](Parameters& p) { p.material = Material::steel; },
      [](Parameters& p) { p.width = 5e-324; },
      [](Parameters& p) { p.seed = 1; },
      [](Parameters& p) { p.ed_rule = EdRule::tc; },
      [](Parameters& p) { p.random_separation = Flag::yes; },
      [](Parameters& p) { p.geometry = Geometry::vibrated_column; },
      [](Parameters& p) { p.geometry = Geometry::lattice; },
      [](Parameters& p) { p.rows += 1; },
      [](Parameters& p) { p.columns += 1; },
      [](Parameters& p) { p.D_t = 5e-324; },
      [](Parameters& p) { p.side_walls = SideWalls::fixed; },
      [](Parameters& p) { p.gravity = std::nextafter(p.gravity, 0.0); },
      [](Parameters& p) { p.frequency = std::nextafter(p.frequency, 0.0); },
      [](Parameters& p) { p.alpha = 5e-324; },
      [](Parameters& p) { p.A0 = 5e-324; },
      [](Parameters& p) { p.periods += 1; },
      [](Parameters& p) { p.transient += 1; }};
  for (const auto& change : changes) {
    Parameters changed;
    change(changed);
    keys.insert(content_key(changed));
  }
  EXPECT_EQ(keys.size(), changes.size() + 1);
}

TEST(ContentKey, IgnoresPaddingAndTheSignOfZero) {
  alignas(Parameters) unsigned char dirty[sizeof(Parameters)], clean[sizeof(Parameters)];
  std::fill(std::begin(dirty), std::end(dirty), static_cast<unsigned char>(0xff));
  std::fill(std::begin(clean), std::end(clean), static_cast<unsigned char>(0x00));
  EXPECT_EQ(content_key(*new (dirty) Parameters{}), content_key(*new (clean) Parameters{}));
  Parameters negative;
  negative.s0 = -0.0;
  EXPECT_EQ(content_key(negative), content_key(Parameters{}));
}
