#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>

#include "store/hdf5/handle.hpp"

/// The one way in for all files of HDF5 that are read, whoever made them. A file is looked at in this order: it is a
/// regular file, it has the bytes of its seal (seal.hpp), HDF5 opens it. Nothing outside the file is ever read:
/// external links, external raw data and virtual datasets are refused.
namespace sigmasweep {

/// Opens a file for reading on this rank alone. A file that another program has open for writing, or had when it was
/// killed, is opened as well. Throws InputNotFound (naming it a `noun`), or IoError.
Handle open_file(const std::string& path, const char* noun);
/// The same without a look at the seal: for a file that has none yet.
Handle open_unsealed(const std::string& path);

/// Opens "a/b/c" below `parent`, where a, b and c are of the file itself. Throw IoError.
Handle open_group(hid_t parent, const std::string& path);
Handle open_dataset(hid_t parent, const std::string& path);

/// Throws IoError unless the file holds bytes enough for `count` elements of `size` bytes each, packed or not: so that
/// no memory is allocated for an extent that only the header knows of.
void require_stored(hid_t dataset, std::uint64_t count, std::uint64_t size);

}  // namespace sigmasweep
