#include "store/table/read.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "model/packing.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/open.hpp"
#include "store/hdf5/trial.hpp"
#include "store/table/checksum.hpp"
#include "store/table/info.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

/// Whether every name of the HDF5 enumeration is one of `names`. HDF5 converts by name, but silently takes a name that
/// it does not find for another one.
bool has_only(hid_t enumeration, std::span<const std::string_view> names) {
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(enumeration), "cannot count the members"));
  for (unsigned i = 0; i < members; ++i)
    if (std::find(names.begin(), names.end(), member_name(enumeration, i)) == names.end()) return false;
  return true;
}

/// Whether a member of this HDF5 type can be read into a field of this type.
bool convertible(hid_t member, FieldType type) {
  const H5T_class_t found = H5Tget_class(member);
  if (type == FieldType::of<Flag>() && found == H5T_ENUM && has_only(member, flag_names)) return true;
  if (const auto names = enumerators(type); !names.empty()) return found == H5T_ENUM && has_only(member, names);
  return found == (type == FieldType::real ? H5T_FLOAT : H5T_INTEGER);
}

/// Whether a truth value of the compound has the names that earlier programs gave it.
bool has_earlier_flags(hid_t type, std::span<const Field> fields) {
  for (const Field& field : fields) {
    if (field.type != FieldType::of<Flag>()) continue;
    const std::int64_t i = check(H5Tget_member_index(type, std::string(field.name).c_str()), "cannot find a member");
    const Handle member(H5Tget_member_type(type, static_cast<unsigned>(i)), H5Tclose, "cannot read a member's type");
    if (has_only(member, enumerators(field.type))) return true;
  }
  return false;
}

/// Those of the `known` fields that the dataset has, in its order. Members of other names are ignored.
std::vector<Field> fields_in(hid_t type, const std::vector<Field>& known) {
  if (H5Tget_class(type) != H5T_COMPOUND) throw IoError("its rows are not compounds");
  std::vector<Field> fields;
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(type), "cannot count the members"));
  for (unsigned i = 0; i < members; ++i) {
    const std::string name = member_name(type, i);
    const auto field = std::find_if(known.begin(), known.end(), [&](const Field& f) { return f.name == name; });
    if (field == known.end()) continue;
    const Handle member(H5Tget_member_type(type, i), H5Tclose, "cannot read the type of member " + name);
    if (!convertible(member, field->type)) throw IoError("member " + name + " is not of the type expected");
    fields.push_back(*field);
  }
  return fields;
}

/// A small file may have many rows that are packed well.
void require_memory_for(std::uint64_t rows) {
  const double memory = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  if (double(rows) * double(sizeof(Row)) > memory)
    throw IoError(fmt::format("its {} rows do not fit into the memory of this machine", rows));
}

/// Reads the `known` members of a dataset of `total_rows` rows into `rows`. Returns the fields that the dataset has.
std::vector<Field> read_rows(hid_t file, const std::string& name, const std::vector<Field>& known,
                             std::uint64_t total_rows, std::vector<Row>& rows) {
  const std::string what = "cannot read dataset " + name;
  const Handle dataset = open_dataset(file, name);
  const Handle stored(H5Dget_type(dataset), H5Tclose, what), space(H5Dget_space(dataset), H5Sclose, what);
  if (H5Sget_simple_extent_ndims(space) != 1 ||
      H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(total_rows))
    throw IoError(fmt::format("dataset {} has not the {} rows that it should have", name, total_rows));
  require_stored(dataset, total_rows, H5Tget_size(stored));
  std::vector<Field> fields = fields_in(stored, known);
  if (fields.empty()) throw IoError("dataset " + name + " has no member that is known");
  if (checksum_of_layout(stored) + checksum_of_stored_rows(dataset, 0, total_rows) != read_checksum(dataset))
    throw IoError(fmt::format("dataset {} is damaged: its rows do not have its checksum", name));
  require_memory_for(total_rows);
  rows.resize(total_rows);
  const Handle type = packed_type(fields, has_earlier_flags(stored, fields));
  const std::size_t size = packed_size(fields);
  const std::uint64_t at_a_time = 1 << 16;
  std::vector<std::byte> buffer(size * std::min(total_rows, at_a_time));
  for (hsize_t first = 0; first < total_rows; first += at_a_time) {
    const hsize_t count = std::min<hsize_t>(at_a_time, total_rows - first);
    const Handle in_memory(H5Screate_simple(1, &count, nullptr), H5Sclose, what);
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, &first, nullptr, &count, nullptr), what);
    check(H5Dread(dataset, type, in_memory, space, H5P_DEFAULT, buffer.data()), what);
    for (hsize_t k = 0; k < count; ++k)
      if (!unpack(fields, buffer.data() + k * size, rows[first + k]))
        throw IoError(fmt::format("row {} of dataset {} has a value that is none of its names", first + k, name));
  }
  return fields;
}

Table read_open_table(const std::string& path) {
  const Handle file = open_file(path, "table");
  StoredInfo stored = read_info(file);
  Table table;
  table.info = std::move(stored.info);
  std::vector<Field> of_results;
  for (const auto list : {parameter_fields(), result_fields()})
    of_results.insert(of_results.end(), list.begin(), list.end());
  const auto of_timings = timing_fields();
  table.columns = read_rows(file, "results", of_results, stored.rows, table.rows);
  read_rows(file, "timings", {of_timings.begin(), of_timings.end()}, stored.rows, table.rows);
  for (std::uint64_t k = 0; k < stored.rows; ++k) table.rows[k].index = table.info.slice.row(k);
  return table;
}

}  // namespace

Table read_table(const std::string& path) {
  const Hdf5Session session;
  try {
    return read_after_trial(path, [&] { return read_open_table(path); });
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} is not a whole table of sigmasweep: {}", path, error.what()));
  }
}

}  // namespace sigmasweep
