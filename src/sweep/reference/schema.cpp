#include "sweep/reference/schema.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sweep/reference/parameter.hpp"
#include "sweep/spec/document.hpp"
#include "sweep/spec/tuples/axis.hpp"

namespace sigmasweep {
namespace {

using Json = nlohmann::ordered_json;
using spec::KeyForm;
using spec::KeyInfo;

Json of_type(std::string_view type) { return {{"type", type}}; }
Json one_of(std::span<const std::string_view> names) { return {{"enum", names}}; }
Json defined(std::string_view name) { return {{"$ref", fmt::format("#/definitions/{}", name)}}; }
Json any_of(std::vector<Json> forms) { return {{"anyOf", std::move(forms)}}; }

Json array_of(Json items, std::size_t least) {
  Json array = of_type("array");
  array["items"] = std::move(items);
  array["minItems"] = least;
  return array;
}

Json point() {
  Json pair = array_of(of_type("number"), 2);
  pair["maxItems"] = 2;
  return pair;
}

Json object_of(const std::vector<KeyInfo>& keys);

/// The schema of a key's value, without its description.
Json value_of(const KeyInfo& key) {
  switch (key.form) {
    case KeyForm::text:
    case KeyForm::condition: return of_type("string");
    case KeyForm::expression:
      return key.also_number ? any_of({of_type("string"), of_type("number")}) : of_type("string");
    case KeyForm::number: return of_type("number");
    case KeyForm::whole_number: return of_type("integer");
    case KeyForm::truth: return of_type("boolean");
    case KeyForm::choice: return one_of(key.choices);
    case KeyForm::choices: return array_of(one_of(key.choices), 1);
    case KeyForm::numbers: return array_of(of_type("number"), 1);
    case KeyForm::fields: return any_of({defined("field"), array_of(defined("field"), 0)});
    case KeyForm::point: return point();
    case KeyForm::groups: return array_of(array_of(defined("parameter"), 2), 0);
    case KeyForm::names: return array_of(defined("parameter"), 1);
    case KeyForm::table: return object_of(key.keys());
    case KeyForm::tables: return array_of(object_of(key.keys()), 0);
    case KeyForm::one_or_several: return any_of({object_of(key.keys()), array_of(object_of(key.keys()), 1)});
  }
  return Json::object();
}

Json described(std::string description, const Json& value) {
  Json schema = {{"description", std::move(description)}};
  schema.update(value);
  return schema;
}

std::string description_of(const KeyInfo& key) {
  return key.usual.empty() ? std::string(key.meaning) : fmt::format("{}; default: {}", key.meaning, key.usual);
}

Json object_of(const std::vector<KeyInfo>& keys) {
  Json object = of_type("object");
  object["properties"] = Json::object();
  for (const KeyInfo& key : keys)
    object["properties"][std::string(key.name)] = described(description_of(key), value_of(key));
  object["additionalProperties"] = false;
  return object;
}

/// A parameter: a value, a list of values, or, of numbers, a range, a sample or an expression.
Json setting_of(const ParameterField& field) {
  const bool named = !enumerators(field.type).empty();
  const Json value = field.type == FieldType::of<Flag>() ? of_type("boolean")
                     : named                             ? one_of(enumerators(field.type))
                     : field.type == FieldType::integer  ? of_type("integer")
                                                         : of_type("number");
  std::vector<Json> forms{value, array_of(value, 1)};
  if (!named) forms.push_back(defined("range"));
  if (!named) forms.push_back(of_type("string"));  // an expression
  return any_of(std::move(forms));
}

/// What [sweep] and [defaults] may have: the parameters before the other keys.
Json tuples(const KeyInfo& table) {
  Json schema = object_of(table.keys()), properties = Json::object();
  for (const ParameterField& field : fields_of_parameters())
    properties[std::string(field.name)] = described(parameter_line(field), setting_of(field));
  properties.update(schema["properties"]);
  schema["properties"] = std::move(properties);
  return schema;
}

Json names_of(std::span<const Field> fields) {
  Json names = Json::array();
  for (const Field& field : fields) names.push_back(field.name);
  return {{"enum", std::move(names)}};
}

}  // namespace

std::string spec_schema(std::span<const SpecSection> sections) {
  const std::vector<KeyInfo> tables = spec::keys_of_spec(sections);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "sigmasweep spec"}};
  schema.update(object_of(tables));
  const Json some = defined("tuples"), several = array_of(some, 1);
  Json all_tuples;
  for (const KeyInfo& table : tables) {
    if (table.name != "sweep" && table.name != "defaults") continue;
    const Json form = table.name == "sweep" ? any_of({some, several}) : some;
    schema["properties"][std::string(table.name)] = described(description_of(table), form);
    all_tuples = tuples(table);
  }
  schema["required"] = {"sweep"};
  Json range = object_of(spec::keys_of_axis());
  range["anyOf"] = {{{"required", {"from", "to"}}}, {{"required", {"mean", "sd"}}}};
  schema["definitions"] = {{"tuples", std::move(all_tuples)},
                           {"range", std::move(range)},
                           {"parameter", names_of(parameter_fields())},
                           {"field", names_of(all_fields())}};
  return schema.dump(1);
}

}  // namespace sigmasweep
