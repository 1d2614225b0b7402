#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "store/journal/record.hpp"
#include "store/table/table_info.hpp"

/// The description of a sweep in its journal: a JSON object of the sweep's spec and of the run that began it, for
/// programs that read a journal without the spec.
namespace sigmasweep {

/// The sweep's description as text. The build and the physics version are this program's.
std::string description_of(const TableInfo& info);

/// What a description says; nothing if it is not a description.
std::optional<TableInfo> parse_description(std::string_view text);

/// The text between the header and the first record; nothing if it is not the one that the header tells. Throws
/// IoError.
std::optional<std::string> read_description(const File& file, const std::string& path, const JournalHeader& header);

}  // namespace sigmasweep
