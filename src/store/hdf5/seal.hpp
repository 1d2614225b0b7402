#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/file.hpp"

/// The seal is the last 16 bytes of a file: a magic number and xxh3 of all bytes before. It stands behind the end that
/// HDF5 knows of, and HDF5's readers ignore it. With it damage is found before HDF5 interprets the file; HDF5 itself
/// checks little, and crashes over some damage. A program that changes the file through HDF5 cuts the seal off; then
/// the checksums of the datasets remain.
///
/// HDF5's note that a program has the file open for writing is not sealed: it stays in the superblock when that program
/// is killed. It counts as 0, and so does the superblock's own checksum, where there is one: HDF5 compares that itself.
namespace sigmasweep {

/// Puts a seal at the end of the file and syncs it. Throws IoError.
void seal(const std::string& path);
/// Puts a seal at the end of a file's bytes.
void seal(std::vector<std::byte>& image);

bool has_seal(const File& file);

/// Throws IoError for a file that has a seal but not the bytes that were sealed.
void check_seal(const File& file, const std::string& path);

/// Whether the superblock notes that a program has the file open for writing.
bool is_noted_as_open(const File& file, const std::string& path);

}  // namespace sigmasweep
