#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// The checksum of a dataset of a table, stored as its attribute `checksum` in hexadecimal: the sum, modulo 2^64, of
/// xxh3 of the layout's text, and of xxh3 of each row's bytes as they are in the file, seeded with the row's number. So
/// the ranks sum their own rows in any division, and a row is good at its own place only.
namespace sigmasweep {

/// Checksum of the text that describes the members of a compound type of the file: a line "name offset type" for each
/// member, types as numpy writes them ("<f8"), an enumeration followed by its " name=value". Throws IoError for other
/// types of members.
std::uint64_t checksum_of_layout(hid_t compound);

/// Checksum of whole rows; the first of them has the number `first`.
std::uint64_t checksum_of_rows(std::span<const std::byte> rows, std::size_t row_size, std::uint64_t first);

/// Checksum of rows first, ..., first + rows - 1 of a one-dimensional dataset. Throws IoError.
std::uint64_t checksum_of_stored_rows(hid_t dataset, std::uint64_t first, std::uint64_t rows);

/// Make the attribute, change it and read it. Throw IoError.
void write_checksum(hid_t dataset, std::uint64_t checksum);
void replace_checksum(hid_t dataset, std::uint64_t checksum);
std::uint64_t read_checksum(hid_t dataset);

/// A number of 16 hexadecimal digits; throws IoError naming `attribute`.
std::uint64_t parse_hexadecimal(const std::string& text, const char* attribute);

}  // namespace sigmasweep
