#pragma once

#include <cstddef>
#include <span>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

/// Rows as bytes: the wanted fields one after another without padding, so that equal rows are equal bytes. Both the
/// records of a journal and the rows of a table have this form.
namespace sigmasweep {

/// Bytes that one value of this type takes.
std::size_t packed_size(FieldType type);
/// Bytes that these fields of one row take.
std::size_t packed_size(std::span<const Field> fields);

/// Writes packed_size(fields) bytes to `out`.
void pack(std::span<const Field> fields, const Row& row, std::byte* out);

/// Sets these fields of `row` from packed_size(fields) bytes; false if an enumerator has a number that has no name.
bool unpack(std::span<const Field> fields, const std::byte* in, Row& row);

}  // namespace sigmasweep
