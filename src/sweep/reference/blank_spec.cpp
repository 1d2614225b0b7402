#include "sweep/reference/blank_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "model/fields/conditions.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/spec/document.hpp"

namespace sigmasweep {
namespace {

/// A parameter of the example, with its value in TOML.
struct Given {
  std::string_view name, value;
};

constexpr auto collision = std::to_array<Given>({
    {"epsilon", "0.9"},
    {"v0", "1.0"},
    {"tc", "2e-5"},
    {"sigma", R"({ from = 0.01, to = 10, count = 31, scale = "log" })"},
});
constexpr auto vibration = std::to_array<Given>({
    {"epsilon", "0.92"},
    {"tc", "1e-4"},
    {"frequency", "20"},
    {"alpha", "[2, 4, 6, 8, 10]"},
});

std::vector<Given> example_of(Geometry geometry) {
  const bool lattice = conditions::lattice.holds({.geometry = geometry}),
             vibrated = conditions::vibrates.holds({.geometry = geometry});
  std::vector<Given> example{lattice ? Given{"rows", vibrated ? "4" : "10"} : Given{"N", "[5, 10, 20]"}};
  if (lattice) example.push_back({"columns", vibrated ? "6" : "13"});
  if (vibrated)
    example.insert(example.end(), vibration.begin(), vibration.end());
  else
    example.insert(example.end(), collision.begin(), collision.end());
  return example;
}

/// Whether tuples of this geometry may use the parameter, with some values of the others.
bool may_use(Geometry geometry, const ParameterField& field) {
  const bool lattice = conditions::lattice.holds({.geometry = geometry}),
             vibrated = conditions::vibrates.holds({.geometry = geometry});
  const auto needs = [&](const Condition& condition) {
    return std::ranges::find(field.applies, &condition) != field.applies.end();
  };
  if (needs(conditions::lattice)) return lattice;
  if (needs(conditions::column) || needs(conditions::hard)) return !lattice;
  if (needs(conditions::vibrates)) return vibrated;
  return !(needs(conditions::flies) && vibrated);
}

std::string value_of(const ParameterField& field) {
  const std::string value = text(field, Parameters{});
  const bool quoted = !enumerators(field.type).empty() && field.type != FieldType::of<Flag>();
  return quoted ? fmt::format("\"{}\"", value) : value;
}

std::string line_of(const ParameterField& field, std::string_view value) {
  const std::string unit = field.unit == "1" ? "" : fmt::format(", {}", field.unit);
  return fmt::format("{} = {}  # {}{}\n", field.name, value, field.meaning, unit);
}

std::string parameters(Geometry geometry) {
  const std::vector<Given> example = example_of(geometry);
  std::string given = fmt::format("geometry = \"{}\"\n", name_of(geometry)), others;
  for (const ParameterField& field : fields_of_parameters()) {
    if (field.name == "geometry" || !may_use(geometry, field)) continue;
    const auto found = std::ranges::find(example, field.name, &Given::name);
    if (found != example.end())
      given += line_of(field, found->value);
    else
      others += "# " + line_of(field, value_of(field));
  }
  return given + "\n" + others;
}

std::string comments(const std::vector<spec::KeyInfo>& keys) {
  std::string text;
  for (const spec::KeyInfo& key : keys)
    text += key.usual.empty() ? fmt::format("# {} = ...  # {}\n", key.name, key.meaning)
                              : fmt::format("# {} = ...  # {}; default: {}\n", key.name, key.meaning, key.usual);
  return text;
}

}  // namespace

std::string blank_spec(Geometry geometry, const std::string& name) {
  const bool plain = std::ranges::all_of(
      name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; });
  if (!plain) return blank_spec(geometry, "beads");
  std::string text = fmt::format(
      "# sigmasweep plan {0}.toml     how much is it?\n"
      "# mpirun sigmasweep run {0}.toml     -> {0}.h5\n"
      "# sigmasweep plot {0}.h5 -o {0}.png\n"
      "# A parameter is a value, a list, a range {{ from, to, count, scale }} or a sample {{ sample, from, to, count, "
      "seed }}.\n"
      "# Lines that begin with # are what else there is. 'sigmasweep help spec' explains all.\n\n"
      "title = \"{0}\"\n",
      name);
  for (const spec::KeyInfo& table : spec::keys_of_spec({})) {
    if (table.keys == nullptr || table.name == "defaults") continue;
    const bool is_sweep = table.name == "sweep";
    text += fmt::format("\n{}[{}]  # {}\n", is_sweep ? "" : "# ", table.name, table.meaning);
    if (is_sweep) text += parameters(geometry);
    text += comments(table.keys());
  }
  return text;
}

}  // namespace sigmasweep
