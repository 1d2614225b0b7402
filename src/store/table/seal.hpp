#pragma once

#include <string>

/// The last 16 bytes of a table, behind what HDF5 knows of and passed over by every reader: a magic number and xxh3 of
/// all bytes before. So damage is seen before HDF5 interprets it; HDF5 itself checks little, and crashes over some.
/// Whoever changes the file through HDF5 cuts the seal off: then the datasets' own checksums are what is left.
namespace sigmasweep {

/// Puts a seal at the end of the file and syncs it. Throws IoError.
void seal(const std::string& path);

/// Throws IoError for a file that has a seal but not the bytes that it had then.
void check_seal(const std::string& path);

}  // namespace sigmasweep
