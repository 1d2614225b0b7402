#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/fields.hpp"

namespace sigmasweep {

/// Writes the given columns of rows as text: head(), then record() of each row, then tail().
class RowWriter {
 public:
  explicit RowWriter(std::vector<Field> columns) : columns_(std::move(columns)) {}
  virtual ~RowWriter() = default;
  virtual std::string head() { return {}; }
  virtual std::string record(const Row& row) = 0;
  virtual std::string tail() { return {}; }

 protected:
  std::span<const Field> columns() const { return columns_; }

 private:
  std::vector<Field> columns_;
};

/// A format of rows. Each file in store/rows that defines a NAME_format() is one, and formats.cpp lists them.
struct RowFormat {
  std::string_view name;     ///< "csv"; a file's ending is the same, after a dot
  std::string_view meaning;  ///< a line for help
  std::unique_ptr<RowWriter> (*writer)(std::vector<Field> columns);
};

/// The format whose writer is a `Writer`.
template <class Writer>
RowFormat format_of(std::string_view name, std::string_view meaning) {
  return {name, meaning, [](std::vector<Field> columns) -> std::unique_ptr<RowWriter> {
            return std::make_unique<Writer>(std::move(columns));
          }};
}

}  // namespace sigmasweep
