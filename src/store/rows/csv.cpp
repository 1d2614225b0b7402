#include "store/rows/row_writer.hpp"

namespace sigmasweep {
namespace {

/// A value as RFC 4180 wants it: in quotes where it has a comma, a quote or the end of a line.
std::string quoted(std::string_view value) {
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(value);
  std::string quoted = "\"";
  for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Comma-separated values (RFC 4180, but lines end with LF), with the names of the columns in the first line.
class Csv final : public RowWriter {
 public:
  using RowWriter::RowWriter;
  std::string head() override {
    return line([](const Field& field) { return field.name; });
  }
  std::string record(const Row& row) override {
    return line([&](const Field& field) { return text(field, row); });
  }

 private:
  template <class ValueOf>
  std::string line(ValueOf value_of) const {
    std::string line;
    for (const Field& field : columns()) {
      if (!line.empty()) line += ',';
      line += quoted(value_of(field));
    }
    return line + "\n";
  }
};

}  // namespace

RowFormat csv_format() {
  return format_of<Csv>("csv",
                        "comma-separated values (RFC 4180, lines end with LF), a header with the fields' names, "
                        "numbers to the bit; nan where there is no result");
}

}  // namespace sigmasweep
