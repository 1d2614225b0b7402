#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sigmasweep::spec {

/// The text of a spec in which keys of [sweep] are replaced. A setting is "KEY=VALUE". VALUE is in TOML; names, and a
/// condition for `where`, need no quotes. A key that [sweep] lacks comes behind its others. The last lines of the text
/// say what was set. Throws UsageError for a setting of another form, and where VALUE is none. A text that is not a
/// spec stays as it is.
std::string with_settings(std::string_view text, std::span<const std::string> settings);

}  // namespace sigmasweep::spec
