#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>

/// Attributes of an HDF5 object: UTF-8 text of any length (h5py's str) and whole numbers. All throw IoError.
namespace sigmasweep {

void write_text(hid_t object, const std::string& name, const std::string& text);
/// Replaces the value of an attribute that write_text() made. Throws IoError.
void replace_text(hid_t object, const std::string& name, const std::string& text);
void write_number(hid_t object, const std::string& name, std::uint64_t number);

std::string read_text(hid_t object, const std::string& name);
std::uint64_t read_number(hid_t object, const std::string& name);

}  // namespace sigmasweep
