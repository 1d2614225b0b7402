#include "studies/precision/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <vector>

#include "base/atomic_file.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/tree.hpp"
#include "store/table/info.hpp"
#include "store/table/packing.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

constexpr const char* format = "sigmasweep-precision";
constexpr std::uint64_t format_version = 1;
constexpr std::size_t number_size = 8;  // of a PrecisionField

std::size_t row_size(std::span<const Field> parameters) {
  return packed_size(parameters) + number_size * precision_fields().size();
}

Handle row_type(std::span<const Field> parameters) {
  const char* const what = "cannot make a data type";
  Handle type(H5Tcreate(H5T_COMPOUND, row_size(parameters)), H5Tclose, what);
  std::size_t offset = 0;
  for (const Field& field : parameters) {
    check(H5Tinsert(type, std::string(field.name).c_str(), offset, value_type(field.type)), what);
    offset += packed_size(field.type);
  }
  for (const PrecisionField& field : precision_fields()) {
    check(H5Tinsert(type, std::string(field.name).c_str(), offset, field.real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64),
          what);
    offset += number_size;
  }
  return type;
}

std::vector<std::byte> packed(std::span<const Field> parameters, std::span<const PrecisionRow> rows) {
  std::vector<std::byte> bytes(rows.size() * row_size(parameters));
  std::byte* out = bytes.data();
  for (const PrecisionRow& each : rows) {
    Row row;
    row.parameters = each.parameters;
    pack(parameters, row, out);
    out += packed_size(parameters);
    for (const PrecisionField& field : precision_fields()) {
      std::memcpy(out, reinterpret_cast<const std::byte*>(&each) + field.offset, number_size);
      out += number_size;
    }
  }
  return bytes;
}

void put_rows(hid_t file, std::span<const Field> parameters, std::span<const PrecisionRow> rows) {
  const char* const what = "cannot write dataset precision";
  const Handle type = row_type(parameters);
  const hsize_t count = rows.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, what);
  Handle dataset(H5Dcreate2(file, "precision", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose, what);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed(parameters, rows).data()), what);
  const auto describe = [&](std::string_view name, std::string_view unit, std::string_view meaning) {
    write_text(dataset, fmt::format("unit:{}", name), std::string(unit));
    write_text(dataset, fmt::format("meaning:{}", name), std::string(meaning));
  };
  for (const Field& field : parameters) describe(field.name, field.unit, field.meaning);
  for (const PrecisionField& field : precision_fields()) describe(field.name, field.unit, field.meaning);
  dataset.close(what);
}

/// HDF5 finds the members by name.
std::vector<PrecisionRow> get_rows(hid_t file) {
  const char* const what = "cannot read dataset precision";
  const std::vector<Field> parameters{*find_field("integrator")};
  const Handle type = row_type(parameters), dataset(H5Dopen2(file, "precision", H5P_DEFAULT), H5Dclose, what);
  const Handle stored(H5Dget_type(dataset), H5Tclose, what), space(H5Dget_space(dataset), H5Sclose, what);
  const auto count = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space), what));
  if (const std::uint64_t size = H5Tget_size(stored); size == 0 || H5Dget_storage_size(dataset) / size != count)
    throw IoError("dataset precision has not the rows that it should have");
  std::vector<std::byte> bytes(count * row_size(parameters));
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), what);
  std::vector<PrecisionRow> rows(count);
  const std::byte* in = bytes.data();
  for (PrecisionRow& each : rows) {
    Row row;
    if (!unpack(parameters, in, row)) throw IoError("an integrator has no name");
    each.parameters = row.parameters;
    in += packed_size(parameters);
    for (const PrecisionField& field : precision_fields()) {
      std::memcpy(reinterpret_cast<std::byte*>(&each) + field.offset, in, number_size);
      in += number_size;
    }
  }
  return rows;
}

}  // namespace

bool is_precision_table(const std::string& path) {
  const Hdf5Session session;
  try {
    return read_text(open_for_reading(path), "format") == format;
  } catch (const IoError&) {
    return false;
  }
}

PrecisionTable read_precision_table(const std::string& path) {
  if (!std::filesystem::exists(path)) throw InputNotFound(fmt::format("there is no table {}", path));
  const Hdf5Session session;
  try {
    const Handle file = open_for_reading(path);
    return {read_text(file, "spec"), get_rows(file)};
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} is not a precision study of sigmasweep: {}", path, error.what()));
  }
}

void write_precision_table(const std::string& path, const TableInfo& info, std::span<const Field> parameters,
                           std::span<const PrecisionRow> rows) {
  const Hdf5Session session;
  std::vector<Field> columns(parameters.begin(), parameters.end());
  if (std::ranges::find(columns, "integrator", &Field::name) == columns.end())
    columns.push_back(*find_field("integrator"));
  const Handle file = h5md::new_file();
  write_info(file, format, format_version, info, rows.size());
  put_rows(file, columns, rows);
  write_whole_file(path, h5md::image_of(file));
}

}  // namespace sigmasweep
