#pragma once

#include <hdf5.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "sigmasweep/model/fields.hpp"
#include "store/hdf5/handle.hpp"

/// The HDF5 types of a table, for the writer and the reader.
namespace sigmasweep {

inline constexpr const char* table_format = "sigmasweep-table";
inline constexpr std::uint64_t table_format_version = 2;

/// The names of false and true in a table.
inline constexpr std::array<std::string_view, 2> flag_names{"FALSE", "TRUE"};

/// The HDF5 type of one value: a number of the machine, or an enumeration with the names of its values. A truth value
/// is the enumeration of FALSE and TRUE that h5py takes for bool.
Handle value_type(FieldType type);

/// The compound of `fields` as pack() lays them out. The same in the file and in memory: with nothing to convert,
/// HDF5 does collective transfers collectively (with a conversion it falls back to independent ones, silently).
/// Earlier programs wrote truth values with the names that specs have for them.
Handle packed_type(std::span<const Field> fields, bool of_earlier_program = false);

/// The name of a member of a compound or an enumeration. Throws IoError.
std::string member_name(hid_t type, unsigned i);

}  // namespace sigmasweep
