#pragma once

#include <string>

/// The seal is the last 16 bytes of a table: a magic number and xxh3 of all bytes before. It stands behind the end that
/// HDF5 knows of, and HDF5's readers ignore it. With it damage is found before HDF5 interprets the file; HDF5 itself
/// checks little, and crashes over some damage. A program that changes the file through HDF5 cuts the seal off; then
/// the checksums of the datasets remain.
namespace sigmasweep {

/// Puts a seal at the end of the file and syncs it. Throws IoError.
void seal(const std::string& path);

/// Throws IoError for a file that has a seal but not the bytes that were sealed.
void check_seal(const std::string& path);

}  // namespace sigmasweep
