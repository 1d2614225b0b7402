#pragma once

#include <span>
#include <string>

#include "store/table/types.hpp"

/// Where a table may be written.
namespace sigmasweep {

/// Throws OutputError where a table of this format must not be written: to a stream or a device, over one of these
/// inputs, or over a file that is not such a table. A damaged one counts as one, and so does an empty file.
void require_place_for_table(const std::string& path, std::span<const std::string> inputs,
                             const std::string& format = table_format);

/// Whether a file was made by this program, by what its bytes say of themselves: it begins as an HDF5 file or ends with
/// a seal, and names `format`. False for anything else than a regular file. An empty file counts as one of ours.
bool is_file_of_ours(const std::string& path, const std::string& format);

}  // namespace sigmasweep
