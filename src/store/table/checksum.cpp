#include "store/table/checksum.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/handle.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

const char* const what = "cannot read the type of a row";

std::string number_name(hid_t type) {
  const std::array<std::pair<hid_t, const char*>, 20> known{
      {{H5T_IEEE_F64LE, "<f8"}, {H5T_IEEE_F64BE, ">f8"}, {H5T_IEEE_F32LE, "<f4"}, {H5T_IEEE_F32BE, ">f4"},
       {H5T_STD_I64LE, "<i8"},  {H5T_STD_I64BE, ">i8"},  {H5T_STD_U64LE, "<u8"},  {H5T_STD_U64BE, ">u8"},
       {H5T_STD_I32LE, "<i4"},  {H5T_STD_I32BE, ">i4"},  {H5T_STD_U32LE, "<u4"},  {H5T_STD_U32BE, ">u4"},
       {H5T_STD_I16LE, "<i2"},  {H5T_STD_I16BE, ">i2"},  {H5T_STD_U16LE, "<u2"},  {H5T_STD_U16BE, ">u2"},
       {H5T_STD_I8LE, "|i1"},   {H5T_STD_U8LE, "|u1"},   {H5T_STD_I8BE, "|i1"},   {H5T_STD_U8BE, "|u1"}}};
  for (const auto& [number, name] : known)
    if (H5Tequal(type, number) > 0) return name;
  throw IoError("a member is of a type that is not known");
}

std::string type_text(hid_t type) {
  if (H5Tget_class(type) != H5T_ENUM) return number_name(type);
  const Handle base(H5Tget_super(type), H5Tclose, what);
  std::string text = number_name(base);
  if (H5Tget_size(type) != 1) throw IoError("an enumeration does not take one byte");
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(type), what));
  for (unsigned i = 0; i < members; ++i) {
    std::uint8_t value = 0;
    check(H5Tget_member_value(type, i, &value), what);
    text += fmt::format(" {}={}", member_name(type, i), value);
  }
  return text;
}

}  // namespace

std::uint64_t checksum_of_layout(hid_t compound) {
  if (H5Tget_class(compound) != H5T_COMPOUND) throw IoError("its rows are not compounds");
  std::string layout;
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(compound), what));
  for (unsigned i = 0; i < members; ++i) {
    const Handle member(H5Tget_member_type(compound, i), H5Tclose, what);
    layout += fmt::format("{} {} {}\n", member_name(compound, i), H5Tget_member_offset(compound, i), type_text(member));
  }
  return XXH3_64bits(layout.data(), layout.size());
}

std::uint64_t checksum_of_rows(std::span<const std::byte> rows, std::size_t row_size, std::uint64_t first) {
  std::uint64_t sum = 0;
  for (; !rows.empty(); rows = rows.subspan(row_size)) sum += XXH3_64bits_withSeed(rows.data(), row_size, first++);
  return sum;
}

std::uint64_t checksum_of_stored_rows(hid_t dataset, std::uint64_t first, std::uint64_t rows) {
  constexpr std::uint64_t bytes_at_a_time = std::uint64_t{1} << 20;
  const char* const cannot = "cannot read the rows";
  // Read in the file's own type, so that nothing is converted.
  const Handle type(H5Dget_type(dataset), H5Tclose, cannot), space(H5Dget_space(dataset), H5Sclose, cannot);
  const std::size_t row_size = H5Tget_size(type);
  if (row_size == 0) throw IoError(cannot);
  const std::uint64_t at_a_time = std::max<std::uint64_t>(bytes_at_a_time / row_size, 1);
  std::vector<std::byte> buffer(row_size * std::min(rows, at_a_time));
  std::uint64_t sum = 0;
  for (const std::uint64_t end = first + rows; first < end;) {
    const hsize_t start = first, now = std::min(at_a_time, end - first);
    const Handle in_memory(H5Screate_simple(1, &now, nullptr), H5Sclose, cannot);
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &now, nullptr), cannot);
    check(H5Dread(dataset, type, in_memory, space, H5P_DEFAULT, buffer.data()), cannot);
    sum += checksum_of_rows(std::span(buffer).first(now * row_size), row_size, first);
    first += now;
  }
  return sum;
}

void write_checksum(hid_t dataset, std::uint64_t checksum) {
  write_text(dataset, "checksum", fmt::format("{:016x}", checksum));
}

void replace_checksum(hid_t dataset, std::uint64_t checksum) {
  replace_text(dataset, "checksum", fmt::format("{:016x}", checksum));
}

std::uint64_t read_checksum(hid_t dataset) { return parse_hexadecimal(read_text(dataset, "checksum"), "checksum"); }

std::uint64_t parse_hexadecimal(const std::string& text, const char* attribute) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, 16);
  if (error != std::errc{} || stop != end)
    throw IoError(fmt::format("attribute {} is not a hexadecimal number", attribute));
  return number;
}

}  // namespace sigmasweep
