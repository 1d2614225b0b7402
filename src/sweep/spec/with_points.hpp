#pragma once

#include <string>
#include <string_view>

namespace sigmasweep::spec {

/// A spec with the contents of the files that its keys `points` name in place of the names, so that the text alone
/// tells all tuples. Names are relative to the folder of the spec. The lines of the text stay where they are. Throws
/// InputNotFound for a file that cannot be read. A text that is no TOML is returned as it is.
std::string with_points(std::string_view text, const std::string& spec_path);

}  // namespace sigmasweep::spec
