#include "studies/precision/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/atomic_file.hpp"
#include "model/packing.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/long_text.hpp"
#include "store/hdf5/open.hpp"
#include "store/hdf5/seal.hpp"
#include "store/hdf5/tree.hpp"
#include "store/hdf5/trial.hpp"
#include "store/table/checksum.hpp"
#include "store/table/info.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

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
  const std::vector<std::byte> bytes = packed(parameters, rows);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), what);
  write_checksum(dataset, checksum_of_layout(type) + checksum_of_rows(bytes, row_size(parameters), 0));
  const auto describe = [&](std::string_view name, std::string_view unit, std::string_view meaning) {
    write_text(dataset, fmt::format("unit:{}", name), std::string(unit));
    write_text(dataset, fmt::format("meaning:{}", name), std::string(meaning));
  };
  for (const Field& field : parameters) describe(field.name, field.unit, field.meaning);
  for (const PrecisionField& field : precision_fields()) describe(field.name, field.unit, field.meaning);
  dataset.close(what);
}

/// Earlier versions of the program wrote no checksum.
void require_checksum(hid_t dataset, hid_t stored, std::uint64_t count) {
  if (check(H5Aexists(dataset, "checksum"), "cannot look for the checksum") == 0) return;
  if (checksum_of_layout(stored) + checksum_of_stored_rows(dataset, 0, count) != read_checksum(dataset))
    throw IoError("dataset precision is damaged: its rows do not have its checksum");
}

/// HDF5 finds the members by name.
std::vector<PrecisionRow> get_rows(hid_t file) {
  const char* const what = "cannot read dataset precision";
  const std::vector<Field> parameters{*find_field("integrator")};
  const Handle type = row_type(parameters), dataset = open_dataset(file, "precision");
  const Handle stored(H5Dget_type(dataset), H5Tclose, what), space(H5Dget_space(dataset), H5Sclose, what);
  const auto count = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space), what));
  if (H5Sget_simple_extent_ndims(space) != 1 || count == 0) throw IoError("it has no rows");
  require_stored(dataset, count, H5Tget_size(stored));
  require_checksum(dataset, stored, count);
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
    return read_after_trial(path, [&] { return read_text(open_file(path, "table"), "format") == precision_format; });
  } catch (const Error&) {
    return false;
  }
}

PrecisionTable read_precision_table(const std::string& path) {
  const Hdf5Session session;
  try {
    return read_after_trial(path, [&] {
      const Handle file = open_file(path, "table");
      return PrecisionTable{read_long_text(file, "spec"), get_rows(file)};
    });
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
  write_info(file, precision_format, format_version, info, rows.size());
  write_long_texts(file, info);
  put_rows(file, columns, rows);
  std::vector<std::byte> image = h5md::image_of(file);
  seal(image);
  write_whole_file(path, image);
}

}  // namespace sigmasweep
