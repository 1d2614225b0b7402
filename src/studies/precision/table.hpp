#pragma once

#include <span>
#include <string>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "store/table/table_info.hpp"
#include "studies/precision/study.hpp"

namespace sigmasweep {

inline constexpr const char* precision_format = "sigmasweep-precision";

/// Writes a precision study: a compound dataset /precision, one row for each scene and setting, with these parameters,
/// the integrator and precision_fields(); units and meanings as its attributes unit:X and meaning:X; root attributes as
/// those of a table, and a checksum and a seal like a table's. PATH is complete or as it was before. Throws OutputError
/// or IoError.
void write_precision_table(const std::string& path, const TableInfo& info, std::span<const Field> parameters,
                           std::span<const PrecisionRow> rows);

/// Whether the file has the format attribute of a precision study.
bool is_precision_table(const std::string& path);

/// A precision study that was read from a file.
struct PrecisionTable {
  std::string spec_text;
  std::vector<PrecisionRow> rows;  ///< of the parameters with the integrator only: the scene's are the spec's
};

/// Reads a study. Throws InputNotFound, or IoError for another file.
PrecisionTable read_precision_table(const std::string& path);

}  // namespace sigmasweep
