#pragma once

#include <hdf5.h>

#include <string>

/// Texts of any length, such as a spec of 4 MB. A text of up to 60 000 bytes is an attribute of its object; a longer
/// one is a scalar dataset of the same name below the object, a UTF-8 string of fixed length: HDF5 limits attributes to
/// 64 kB. In h5py: `file.attrs["spec"]`, or `file["spec"].asstr()[()]`.
namespace sigmasweep {

/// Writes the attribute, or makes the dataset. Collective where the file is open on several ranks. Throws IoError.
void create_long_text(hid_t object, const std::string& name, const std::string& text);
/// Writes the text into its dataset, if there is one. On one rank. Throws IoError.
void fill_long_text(hid_t object, const std::string& name, const std::string& text);

std::string read_long_text(hid_t object, const std::string& name);

}  // namespace sigmasweep
