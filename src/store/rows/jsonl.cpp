#include "store/rows/json.hpp"
#include "store/rows/row_writer.hpp"

namespace sigmasweep {
namespace {

/// JSON Lines: an object a line, so that a reader needs no more than a line at a time.
class JsonLines final : public RowWriter {
 public:
  using RowWriter::RowWriter;
  std::string record(const Row& row) override { return json_of(columns(), row).dump() + "\n"; }
};

}  // namespace

RowFormat jsonl_format() { return format_of<JsonLines>("jsonl", "JSON Lines: an object a line, one a row"); }

}  // namespace sigmasweep
