#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "store/journal/record.hpp"
#include "store/table/table_info.hpp"

/// The description of a sweep in its journal: a JSON object of the sweep's spec and of the run that began it, for
/// programs that read a journal without the spec.
namespace sigmasweep {

/// What a description says.
struct JournalDescription {
  TableInfo info;
  std::vector<Field> results;  ///< that a record has; empty: all that this program knows
};

/// The description as text. The build and the physics version are this program's.
std::string description_of(const JournalDescription& description);

/// Nothing if the text is not a description, or has results that this program does not know.
std::optional<JournalDescription> parse_description(std::string_view text);

/// The text between the header and the first record; nothing if it is not the one that the header tells. Throws
/// IoError.
std::optional<std::string> read_description(const File& file, const std::string& path, const JournalHeader& header);

}  // namespace sigmasweep
