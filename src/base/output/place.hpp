#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/file.hpp"

/// The place that an output path names. All writers follow the same rule: a symbolic link stands for its target; a
/// device, a FIFO and "-" are streams, which are written to and never replaced; the file of an input is never replaced.
namespace sigmasweep {

/// The path that `path` stands for when its symbolic links are followed, whether there is a file or not. Throws
/// OutputError for links in a circle.
std::string linked_file(const std::string& path);

/// The name of a file beside the one that `path` stands for: its journal, say.
std::string beside(const std::string& path, const std::string& suffix);

/// Opens the stream that the path names: "-" and /dev/stdout for standard output, /dev/fd/N for a descriptor that is
/// open (a shell's >( )), a character device, or a FIFO that a program reads. Nothing where the path names a regular
/// file or no file. Throws OutputError for anything else, such as a directory, and for a FIFO that nobody reads.
std::optional<File> open_stream(const std::string& path);

/// Throws OutputError unless the path names a regular file or no file; `why` says what needs one.
void require_file_place(const std::string& path, const std::string& why);

/// Throws OutputError if something of this name is there and is not a regular file; links are not followed.
void require_plain(const std::string& path);

/// Throws OutputError if `output` is the same file as one of these inputs.
void require_other_file(const std::string& output, std::span<const std::string> inputs);

}  // namespace sigmasweep
