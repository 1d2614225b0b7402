#include "cli/json_row.hpp"

#include <cstdint>
#include <string>

namespace sigmasweep {

nlohmann::ordered_json json_of(std::span<const Field> fields, const Row& row) {
  auto document = nlohmann::ordered_json::object();
  for (const Field& field : fields) {
    auto& value = document[std::string(field.name)];
    if (field.type == FieldType::flag)
      value = number(field, row) != 0.0;
    else if (!enumerators(field.type).empty())
      value = text(field, row);
    else if (field.type == FieldType::real)
      value = number(field, row);
    else
      value = static_cast<std::int64_t>(number(field, row));
  }
  return document;
}

}  // namespace sigmasweep
