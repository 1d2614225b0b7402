#pragma once

#include <hdf5.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "store/hdf5/handle.hpp"

/// The parts that H5MD files are made of. All throw IoError.
namespace sigmasweep::h5md {

/// A new HDF5 file in memory, of format version 2 as H5MD recommends. It has no time stamps, so that its bytes depend
/// on its content only.
Handle new_file();
/// The bytes of a file in memory.
std::vector<std::byte> image_of(hid_t file);

Handle new_group(hid_t parent, const std::string& name);

void put_text(hid_t object, const std::string& name, const std::string& text);              ///< of fixed length
void put_texts(hid_t object, const std::string& name, std::span<const std::string> texts);  ///< not empty
void put_real(hid_t object, const std::string& name, double value);
void put_whole(hid_t object, const std::string& name, std::int64_t value);
void put_version(hid_t object, int major, int minor);  ///< version [major, minor]
std::string get_text(hid_t object, const std::string& name);
std::vector<std::string> get_texts(hid_t object, const std::string& name);

/// A dataset of doubles with its unit; "" if it has none.
void put_array(hid_t group, const std::string& name, std::span<const double> values, std::vector<hsize_t> extents,
               const std::string& unit);
void put_counts(hid_t group, const std::string& name, std::span<const std::int64_t> values);
/// Reads a dataset that must have these extents. An extent of 0 allows any number, and is set to the number found.
std::vector<double> get_array(hid_t group, const std::string& name, std::vector<hsize_t>& extents);

}  // namespace sigmasweep::h5md
