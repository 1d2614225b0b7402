#include "store/rows/json.hpp"

#include <cstdint>
#include <string>

#include "sigmasweep/model/exact_number.hpp"
#include "store/rows/row_writer.hpp"
#include "store/stored/stored_sweep.hpp"

namespace sigmasweep {
namespace {

/// An array of objects, one a line.
class Json final : public RowWriter {
 public:
  using RowWriter::RowWriter;
  std::string head() override { return "["; }
  std::string record(const Row& row) override {
    const std::string separator = is_first_ ? "\n" : ",\n";
    is_first_ = false;
    return separator + json_of(columns(), row).dump();
  }
  std::string tail() override { return "\n]\n"; }

 private:
  bool is_first_ = true;
};

}  // namespace

nlohmann::ordered_json json_of(std::span<const Field> fields, const Row& row) {
  auto document = nlohmann::ordered_json::object();
  for (const Field& field : fields) {
    auto& value = document[std::string(field.name)];
    if (field.type == FieldType::of<Flag>())
      value = number(field, row) != 0.0;
    else if (!enumerators(field.type).empty())
      value = text(field, row);
    else if (field.type == FieldType::real)
      value = number(field, row);
    else
      value = static_cast<std::int64_t>(exact_number(field, row));
  }
  return document;
}

RowFormat json_format() {
  return format_of<Json>("json", "an array of objects, one a row; null where there is no result");
}

nlohmann::ordered_json counts_by_status(std::span<const Row> rows) {
  auto counts = nlohmann::ordered_json::object();
  for (const auto& [name, count] : count_by_status(rows)) counts[std::string(name)] = count;
  return counts;
}

}  // namespace sigmasweep
